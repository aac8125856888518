// SPDX-License-Identifier: Apache-2.0
// Tests that the window asks where files are of two patients, or of another size than their names
// say, and does what is answered.
#include <QAction>
#include <QDir>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QtTest>
#include <algorithm>
#include <glm/geometric.hpp>

#include "model/edit/settled_units.h"
#include "model/scene_file/scene_file.h"
#include "tests/gui/window_fixture.h"
#include "tests/model/import/volumes/written_volumes.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"
#include "widgets/import_dialog/import_dialog.h"

namespace sline::test {

namespace {

QByteArray maskOf(const QByteArray& patient) {
  const WrittenVolume cube = sampled({12, 12, 12}, glm::dmat4(1.0), [](const glm::dvec3& p) {
    return p.x > 2 && p.x < 9 && p.y > 2 && p.y < 9 && p.z > 2 && p.z < 9 ? 1 : 0;
  });
  QByteArray file = nrrdFile(cube, "left-posterior-superior");
  return file.insert(file.indexOf("\n\n") + 1, "PatientID:=" + patient + "\n");
}

struct Desk {
  WindowFixture f;

  bool asks() {
    return QTest::qWaitFor([this] { return box() != nullptr; }, 60'000);
  }
  QMessageBox* box() {
    auto* found = f.window.findChild<QMessageBox*>(QStringLiteral("patientsDialog"));
    return found && found->isVisible() ? found : nullptr;
  }
  void click(const char* button) {
    QTest::mouseClick(&f.control<QPushButton>(button), Qt::LeftButton);
  }
  bool planned() {
    return QTest::qWaitFor(
        [this] {
          auto* dialog = f.window.findChild<widgets::ImportDialog*>();
          return dialog && dialog->draft().ready();
        },
        60'000);
  }
  std::size_t structures() { return f.session.scene().structuresBelow(model::rootId).size(); }
  float extent() {
    const model::Scene& scene = f.session.scene();
    return scene.find(scene.structuresBelow(model::rootId).front())->mesh->bounds().size().x;
  }
  bool barDoubts() { return f.control<QWidget>("scaleBar").accessibleName().contains('?'); }
};

}  // namespace

class ImportQuestionsTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_two;
  QTemporaryDir m_small;

 private slots:
  void initTestCase() {
    writeText(m_two.filePath("first.nrrd"), maskOf("QZX7"));
    writeText(m_two.filePath("second.nrrd"), maskOf("QZX8"));
    writeMesh(m_small.filePath("left kidney.stl"), *octahedron({}, 5.0f));
  }

  void patientsAreAsked_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<int>("structures");
    QTest::newRow("together") << "patientsTogether" << 2;
    QTest::newRow("the first") << "patientsFirst" << 1;
    QTest::newRow("neither") << "" << 0;
  }
  void patientsAreAsked() {
    QFETCH(QString, button);
    QFETCH(int, structures);
    for (const bool dialog : {false, true}) {
      Desk desk;
      QVERIFY(desk.f.drop(m_two.path(), dialog ? Qt::ShiftModifier : Qt::NoModifier));
      QVERIFY(desk.asks());
      QVERIFY(desk.f.session.scene().nodes().empty());
      const QString said = desk.box()->text() + desk.box()->informativeText();
      QVERIFY2(said.contains("1: first.nrrd") && said.contains("2: second.nrrd"), qPrintable(said));
      QVERIFY2(!said.contains("QZX"), qPrintable(said));
      if (button.isEmpty()) {
        QTest::keyClick(desk.box(), Qt::Key_Escape);
        QTRY_VERIFY(!desk.box());
        QVERIFY(!desk.f.session.busy());
        QTRY_VERIFY(!desk.f.window.findChild<widgets::ImportDialog*>());
      } else {
        desk.click(qPrintable(button));
        if (dialog) {
          QVERIFY(desk.planned());
          desk.click("importButton");
        }
        QVERIFY(desk.f.settled());
      }
      QCOMPARE(int(desk.structures()), structures);
    }
  }

  void anotherPatientIsNotAddedInSilence() {
    Desk desk;
    QVERIFY(desk.f.drop(m_two.filePath("first.nrrd")));
    QVERIFY(desk.f.settled());
    for (const char* answer : {"", "patientsTogether"}) {
      QVERIFY(desk.f.drop(m_two.filePath("second.nrrd"), Qt::ShiftModifier));
      QVERIFY(desk.planned());
      desk.click("addButton");
      QVERIFY(desk.asks());
      QVERIFY(!desk.box()->findChild<QPushButton*>(QStringLiteral("patientsFirst")));
      QCOMPARE(desk.structures(), std::size_t(1));
      if (*answer)
        desk.click(answer);
      else
        QTest::keyClick(desk.box(), Qt::Key_Escape);
      QTRY_VERIFY(!desk.box());
      QVERIFY(desk.f.settled());
      QCOMPARE(desk.structures(), std::size_t(*answer ? 2 : 1));
    }
  }

  /// A scene that was saved knows whose it is, and the files need no longer be there.
  void savedScenesKnowTheirPatient() {
    const QTemporaryDir folder;
    writeText(folder.filePath("first.nrrd"), maskOf("1\n0020|000d:=1.2.3"));
    writeText(folder.filePath("same.nrrd"), maskOf("1\n0020|000d:=1.2.3"));
    writeText(folder.filePath("other.nrrd"), maskOf("2\n0020|000d:=1.2.9"));
    const QString saved = folder.filePath("first.sline");
    {
      Desk desk;
      QVERIFY(desk.f.drop(folder.filePath("first.nrrd")) && desk.f.settled());
      QVERIFY(model::writeSceneFile(saved.toStdString(), {desk.f.session.scene(), {}, {}, 0}).ok());
    }
    QVERIFY(QFile::remove(folder.filePath("first.nrrd")));
    for (const bool other : {false, true}) {
      Desk desk;
      QVERIFY(desk.f.drop(saved) && desk.f.settled());
      QVERIFY(desk.f.drop(folder.filePath(other ? "other.nrrd" : "same.nrrd"), Qt::ShiftModifier));
      QVERIFY(desk.planned());
      desk.click("addButton");
      if (other) {
        QVERIFY(desk.asks());
        QVERIFY2(desk.box()->informativeText().contains("1: what is open"),
                 qPrintable(desk.box()->informativeText()));
        desk.click("patientsTogether");
      }
      QVERIFY(desk.f.settled());
      QCOMPARE(desk.structures(), std::size_t(2));
    }
  }

  /// A file that has become another patient's is asked about when it is read again, as when it is
  /// added: the scene knows whose it is, even where nothing else of it is left.
  void reloadedFilesAreAskedAbout() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("mask.nrrd");
    writeText(file, maskOf("1\n0020|000d:=1.2.3"));
    Desk desk;
    QVERIFY(desk.f.drop(file) && desk.f.settled());
    const model::Scene before = desk.f.session.scene();
    const int steps = desk.f.session.history().count();
    writeText(file, maskOf("2\n0020|000d:=1.2.9"));
    const auto reload = [&desk] { desk.f.control<QAction>("reload").trigger(); };
    for (const char* answer : {"", "patientsFirst"}) {
      reload();
      QVERIFY(desk.asks());
      const QString said = desk.box()->informativeText();
      QVERIFY2(said.contains("1: what is open") && said.contains("2: mask.nrrd"), qPrintable(said));
      if (*answer)
        desk.click(answer);
      else
        QTest::keyClick(desk.box(), Qt::Key_Escape);
      QTRY_VERIFY(!desk.box());
      QVERIFY(desk.f.settled());
      QVERIFY(desk.f.session.scene() == before);
      QCOMPARE(desk.f.session.history().count(), steps);
    }
    reload();
    QVERIFY(desk.asks());
    desk.click("patientsTogether");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.f.session.history().count(), steps + 1);
    // The same patient's needs no question.
    desk.f.session.undo();
    writeText(file, maskOf("1\n0020|000d:=1.2.3\nanother:=word"));
    reload();
    QVERIFY(desk.f.settled());
    QVERIFY(!desk.box());
    QCOMPARE(desk.f.session.history().count(), steps + 1);
  }

  /// What is added goes where it fits in with what is open.
  void whatIsAddedFitsIn() {
    const QTemporaryDir folder;
    QDir(folder.path()).mkdir("body");
    for (const auto& [name, place] :
         {std::pair("liver", glm::vec3(-70, -280, 10)), std::pair("spine", glm::vec3(0, -190, -5)),
          std::pair("spleen", glm::vec3(80, -230, 15)),
          std::pair("urinary bladder", glm::vec3(0, -270, -140))})
      writeMesh(folder.filePath(QString("body/%1.ply").arg(name)), *octahedron(place, 30.0f),
                model::Frame::lps);
    writeMesh(folder.filePath("growth.ply"), *octahedron({-30, 260, -20}, 12.0f));
    Desk desk;
    QVERIFY(desk.f.drop(folder.filePath("body")) && desk.f.settled());
    QVERIFY(desk.f.drop(folder.filePath("growth.ply"), Qt::ShiftModifier));
    QVERIFY(desk.planned());
    desk.click("addButton");
    QVERIFY(desk.f.settled());
    const model::Node& growth = named(desk.f.session.scene(), "growth");
    QCOMPARE(growth.provenance.frame, std::string("RAS"));
    QVERIFY(!growth.provenance.evidence.isSure());  // a box within another is a guess
    QCOMPARE(growth.mesh->bounds().centre(), glm::vec3(30, -260, -20));
    QTRY_VERIFY(desk.f.control<QLabel>("messageText").text().contains("read as RAS"));
  }

  /// A scan without a segmentation brings up the dialog where structures are made of it.
  void scansLeadToTheirTab() {
    const QTemporaryDir folder;
    const WrittenVolume scan = sampled({16, 16, 16}, glm::dmat4(1.0), [](const glm::dvec3& p) {
      const double away = glm::length(p - glm::dvec3(8.0));
      return int(-1000.0 + 90.0 * std::max(0.0, 14.0 - away) + p.x);
    });
    writeText(folder.filePath("scan.nrrd"), nrrdFile(scan, "LPS", "raw", Number::int16));
    Desk desk;
    QVERIFY(desk.f.drop(folder.filePath("scan.nrrd")));
    QVERIFY(desk.planned());
    auto* tabs = desk.f.window.findChild<QTabWidget*>(QStringLiteral("importTabs"));
    QVERIFY(tabs && tabs->isVisible());
    QCOMPARE(tabs->tabText(tabs->currentIndex()), QString("Scan"));
    QVERIFY(!desk.f.control<QWidget>("messageBar").isVisible());
  }

  /// Another unit is not another import: the rest stays as it was chosen.
  void unitKeepsTheRest() {
    const QTemporaryDir folder;
    writeMesh(folder.filePath("left kidney.stl"), *octahedron({}, 5.0f));
    writeMesh(folder.filePath("spleen.stl"), *octahedron({20, 0, 0}, 5.0f));
    writeMesh(folder.filePath("Qzxdoe.stl"), *octahedron({40, 0, 0}, 5.0f));
    Desk desk;
    QVERIFY(desk.f.drop(folder.path(), Qt::ShiftModifier));
    QVERIFY(desk.planned());
    auto& draft = desk.f.window.findChild<widgets::ImportDialog*>()->draft();
    model::ImportOptions options = draft.plan().options;
    options.keepFileNames = true;
    options.smoothing.mode = model::Smoothing::Mode::off;
    draft.setOptions(options);
    QVERIFY(desk.planned());
    draft.choose({named(draft.plan().scene, "spleen").id},
                 [](model::StructureChoice& choice) { choice.include = false; });
    QVERIFY(desk.planned());
    desk.click("importButton");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.structures(), std::size_t(2));
    desk.click("messageRemedy");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.structures(), std::size_t(2));
    const model::Node& kidney = named(desk.f.session.scene(), "left kidney");
    QCOMPARE(kidney.mesh->bounds().size().x, 100.0f);
    QCOMPARE(kidney.mesh->vertexCount(), std::size_t(6));
    QCOMPARE(named(desk.f.session.scene(), "Qzxdoe").name, std::string("Qzxdoe"));
    // And so does the dialog that comes again.
    desk.f.control<QAction>("importAgain").trigger();
    QVERIFY(desk.planned());
    auto& again = desk.f.window.findChild<widgets::ImportDialog*>()->draft();
    QVERIFY(again.plan().options.keepFileNames);
    QVERIFY(!again.plan().choiceOf(named(again.plan().scene, "spleen").id).include);
  }

  void unitIsOffered() {
    Desk desk;
    QVERIFY(desk.f.drop(m_small.path()));
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.extent(), 10.0f);
    QTRY_VERIFY(desk.barDoubts());
    auto& take = desk.f.control<QPushButton>("messageRemedy");
    QVERIFY(take.isVisible() && take.text().contains("cm"));
    desk.click("messageRemedy");
    QVERIFY(desk.f.settled());
    QCOMPARE(desk.extent(), 100.0f);
    QTRY_VERIFY(!desk.barDoubts());
  }

  void sizeIsRight() {
    Desk desk;
    QVERIFY(desk.f.drop(m_small.path()));
    QVERIFY(desk.f.settled());
    // A scene that was saved so asks again.
    const QString saved = desk.f.folder.filePath("doubted.sline");
    QVERIFY(model::writeSceneFile(saved.toStdString(), {desk.f.session.scene(), {}, {}, 0}).ok());
    for (const QString& opened : {QString(), saved}) {
      if (!opened.isEmpty())
        QVERIFY(desk.f.drop(opened) && desk.f.settled());
      QTRY_VERIFY(desk.barDoubts());
      desk.click("messageOther");
      QTRY_VERIFY(!desk.barDoubts());
      QCOMPARE(desk.extent(), 10.0f);
      desk.f.session.undo();
      QTRY_VERIFY(desk.barDoubts());
    }
  }

  void dialogOffersBoth() {
    for (const auto& [button, extent] :
         {std::pair("takeUnitButton", 100.0f), std::pair("keepUnitButton", 10.0f)}) {
      Desk desk;
      QVERIFY(desk.f.drop(m_small.filePath("left kidney.stl"), Qt::ShiftModifier));
      QVERIFY(desk.planned());
      QVERIFY(desk.f.control<QLabel>("importDoubt").text().contains("left kidney"));
      QVERIFY(desk.f.control<QPushButton>(button).isVisible());
      if (const QString file = qEnvironmentVariable("SLINE_UNIT_PICTURE"); !file.isEmpty())
        desk.f.window.findChild<widgets::ImportDialog*>()->grab().save(file);
      desk.click(button);
      QVERIFY(desk.planned());
      QVERIFY(!desk.f.control<QPushButton>(button).isVisible());
      desk.click("importButton");
      QVERIFY(desk.f.settled());
      QCOMPARE(desk.extent(), extent);
      QVERIFY(!model::hasDoubtedUnits(desk.f.session.scene()));
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ImportQuestionsTest)
#include "import_questions_test.moc"
