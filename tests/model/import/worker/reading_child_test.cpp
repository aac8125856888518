// SPDX-License-Identifier: Apache-2.0
// Tests readers that crash, hang, eat memory or lie, in a process of their own: each gives a
// message.
#include <QTemporaryDir>
#include <QtTest>

#include "model/import/plan/import.h"
#include "model/import/worker/exchange.h"
#include "model/import/worker/reading_child.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

namespace sline::test {

using model::RawMeshes;
using model::ReadOptions;

class ReadingChildTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  QString written(const char* deed) {
    const QString path = m_folder.filePath(QStringLiteral("%1.dcm").arg(QLatin1String(deed)));
    writeText(path, deed);
    return path;
  }
  Result<RawMeshes> read(const char* deed, const ReadOptions& options = {}) {
    const std::filesystem::path file = written(deed).toStdString();
    return model::readInChild("DICOM", {&file, 1}, options);
  }

 private slots:
  void init() { qputenv("SLINE_READER", MISBEHAVING_READER); }
  void cleanup() { qunsetenv("SLINE_READER"); }

  void surfacesArriveWhole() {
    const Result<RawMeshes> read = this->read("mesh");
    QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
    QCOMPARE(read->meshes.size(), std::size_t(1));
    const model::RawMesh& mesh = read->meshes.front();
    QCOMPARE(mesh.name, std::string("made"));
    QCOMPARE(mesh.positions.size(), std::size_t(4));
    QVERIFY((mesh.triangles.back() == model::Triangle{1, 2, 3}));
    QVERIFY((mesh.colour == Colour{200, 30, 40}));
    QVERIFY(mesh.opacity && mesh.opacity->value() == 0.5f);
    QVERIFY(mesh.frame == model::Frame::ras);
    QVERIFY((mesh.groups == std::vector<std::string>{"Bones", "Left"}));
    QVERIFY(mesh.visible == false);
    QVERIFY((read->warnings == std::vector<model::ImportWarning>{{"made.dcm", "a warning"}}));
  }

  void faultsAreMessages_data() {
    QTest::addColumn<QString>("reason");
    QTest::newRow("crash") << QStringLiteral("crashed over this file (Segmentation fault)");
    QTest::newRow("loop") << QStringLiteral("did not come to an end within 1 s of computing");
    QTest::newRow("wait") << QStringLiteral("did not come to an end within 6 s");
    QTest::newRow("eat") << QStringLiteral("wanted more than 0.3 GB of memory");
    QTest::newRow("breakOut") << QStringLiteral("kept in");
    QTest::newRow("lie") << QStringLiteral("makes no sense");
    QTest::newRow("leave") << QStringLiteral("gave no answer");
    QTest::newRow("throw") << QStringLiteral("gave up: thrown on purpose");
    QTest::newRow("outOfRange") << QStringLiteral("makes no sense");
    QTest::newRow("refuse") << QStringLiteral("is refused");
  }
  void faultsAreMessages() {
    QFETCH(QString, reason);
    ReadOptions options;
    const char* deed = QTest::currentDataTag();
    // Eating memory takes computing time, too: more than a second on a machine that hands out
    // memory slowly.
    options.limits.childSeconds = qstrcmp(deed, "eat") == 0 ? 60 : 1;
    options.limits.childBytes = 300'000'000;
    const Result<RawMeshes> read = this->read(deed, options);
    QVERIFY(!read.ok());
    const QString text = QString::fromStdString(read.error().text());
    QVERIFY2(text.contains(reason), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("%1.dcm").arg(QLatin1String(deed))), qPrintable(text));
  }

  void cancelEndsIt() {
    ReadOptions options;
    int asked = 0;
    options.goesOn = [&asked] { return ++asked < 4; };
    const Result<RawMeshes> read = this->read("loop", options);
    QVERIFY(!read.ok());
    QCOMPARE(asked, 4);
    // It was not its limit of computing that ended it.
    const QString text = QString::fromStdString(read.error().text());
    QVERIFY2(!text.contains(QStringLiteral("did not come to an end")), qPrintable(text));
  }

  void othersOfItsFolderAreRead() {
    QTemporaryDir folder;
    for (const char* deed : {"crash", "mesh", "throw"})
      writeText(folder.filePath(QStringLiteral("%1.dcm").arg(QLatin1String(deed))), deed);
    const std::vector<std::filesystem::path> inputs{folder.path().toStdString()};
    const Result<model::Imported> imported = model::importInputs(inputs, {.keepFileNames = true});
    QVERIFY2(imported.ok(), imported ? "" : imported.error().text().c_str());
    QCOMPARE(imported->scene.named("made").size(), std::size_t(1));
    int crashes = 0;
    for (const model::ImportWarning& warning : imported->report.warnings)
      crashes += warning.file == "crash.dcm" && warning.reason.find("crashed") != std::string::npos;
    QCOMPARE(crashes, 1);
  }

  void absentReaderIsNamed() {
    qputenv("SLINE_READER", "/nowhere/sline-reader");
    const Result<RawMeshes> read = this->read("mesh");
    QVERIFY(!read.ok());
    const QString text = QString::fromStdString(read.error().text());
    QVERIFY2(text.contains(QStringLiteral("/nowhere/sline-reader could not be started")),
             qPrintable(text));
  }

  // A child that was taken over might give such answers.
  void spoiledAnswersAreRefused() {
    const Result<RawMeshes> whole = read("mesh");
    QVERIFY(whole.ok());
    const std::string bytes = model::encodedAnswer(whole);
    QVERIFY(model::decodedAnswer(bytes).ok());
    for (std::size_t size = 0; size < bytes.size(); ++size)
      QVERIFY(!model::decodedAnswer(std::string_view(bytes).substr(0, size)).ok());
    Mutator mutate(20261123, {});
    int refused = 0;
    for (int i = 0; i < 2000; ++i) {
      const QByteArray spoiled = mutate(QByteArray::fromStdString(bytes));
      const Result<RawMeshes> read =
          model::decodedAnswer({spoiled.constData(), std::size_t(spoiled.size())});
      refused += !read.ok();
      if (!read)
        continue;
      for (const model::RawMesh& mesh : read->meshes)
        for (const model::Triangle& triangle : mesh.triangles)
          QVERIFY(*std::max_element(triangle.begin(), triangle.end()) < mesh.positions.size());
    }
    QVERIFY2(refused > 1000, qPrintable(QString::number(refused)));
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::ReadingChildTest)
#include "reading_child_test.moc"
