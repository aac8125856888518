// SPDX-License-Identifier: Apache-2.0
// Tests on real bodies that the opening look is about what an anatomist would draw them for.
#include <QFileInfo>
#include <QTest>

#include "model/edit/look.h"
#include "model/import/plan/import.h"
#include "model/look/opening_look.h"
#include "tests/support/suite.h"

namespace sline::model {

class OpeningAnatomyTest : public QObject {
  Q_OBJECT

  static std::optional<Scene> body(const QString& path) {
    const QString whole = QStringLiteral(SLINE_TEST_DATA "/") + path;
    if (!QFileInfo::exists(whole))
      return std::nullopt;
    const std::filesystem::path paths[] = {whole.toStdString()};
    auto imported = importInputs(paths, {}, {});
    if (!imported.ok())
      qFatal("%s", imported.error().text().c_str());
    return std::move(imported->scene);
  }

 private slots:
  void subjects_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("title");
    QTest::addColumn<QStringList>("within");
    QTest::addColumn<QStringList>("without");
    QTest::newRow("abdomen") << "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml"
                             << "organs"
                             << QStringList{"liver", "left kidney", "pancreas", "spleen"}
                             << QStringList{"aorta", "Rib9", "rectus abdominis muscle"};
    QTest::newRow("pelvis") << "pelvis/bodyparts3d"
                            << "organs"
                            << QStringList{"urinary bladder", "prostate", "rectum", "left ureter"}
                            << QStringList{"sacrum", "left femur", "abdominal aorta"};
    QTest::newRow("male pelvis") << "pelvis/hra_vh_male"
                                 << "organs" << QStringList{"sigmoid colon", "apex of prostate"}
                                 << QStringList{"sacrum", "ilium compact bone L"};
    QTest::newRow("protein") << "protein/2src.pdb"
                             << "ligands" << QStringList{"ANP oxygen", "ANP pocket"}
                             << QStringList{"Chain A – Tyrosine-protein kinase SRC"};
    QTest::newRow("vessels of a liver")
        << "misc/bp3d_liver_vessels"
        << "what lies in the organs" << QStringList{"Middle hepatic vein", "Left portal vein"}
        << QStringList{"Hepatovenous segment II"};
    QTest::newRow("heart") << "misc/hra/VH_F_Heart.glb"
                           << "everything" << QStringList{"aortic valve"} << QStringList{};
  }
  void subjects() {
    QFETCH(QString, path);
    QFETCH(QString, title);
    QFETCH(QStringList, within);
    QFETCH(QStringList, without);
    const std::optional<Scene> scene = body(path);
    if (!scene)
      SLINE_ABSENT("the anatomy is not there");
    QVERIFY(hasNoLook(*scene));
    const Subject subject = subjectsOf(*scene).front();
    QCOMPARE(QString::fromStdString(subject.title), title);
    const auto has = [&](const QString& name) {
      const std::vector<NodeId> ids = scene->named(name.toStdString());
      if (ids.empty())
        qFatal("no structure is called %s", qPrintable(name));
      return std::find(subject.structures.begin(), subject.structures.end(), ids.front()) !=
             subject.structures.end();
    };
    for (const QString& name : within)
      QVERIFY2(has(name), qPrintable(name));
    for (const QString& name : without)
      QVERIFY2(!has(name), qPrintable(name));
  }

  /// Left and right are drawn alike, the view is from the front, and the picture is filled by the
  /// subject and its neighbours: thighs run out of it.
  void pelvisAsAPlate() {
    const std::optional<Scene> scene = body("pelvis/bodyparts3d");
    if (!scene)
      SLINE_ABSENT("the anatomy is not there");
    FormIndex forms;
    const std::optional<OpeningLook> look = openingLook(*scene, forms, {.aspect = 1.0f});
    QVERIFY(look && look->view == AnatomicalView::anterior);
    const auto styleOf = [&](const char* name) {
      Style style = look->scene.find(look->scene.named(name).front())->style;
      style.colour.reset();
      style.inkColour.reset();
      return style;
    };
    for (const auto& [left, right] :
         {std::pair("left femur", "right femur"), std::pair("left hip bone", "right hip bone"),
          std::pair("left external iliac vein", "right external iliac vein")})
      QCOMPARE(styleOf(left), styleOf(right));
    QVERIFY(*styleOf("left hip bone").gamma > Gamma::clamped(3.0f));
    const Box femur = scene->find(scene->named("left femur").front())->mesh->bounds();
    const Box bladder = scene->find(scene->named("urinary bladder").front())->mesh->bounds();
    const glm::mat4 seen =
        projectionMatrix(look->camera, scene->visibleBounds(), 1.0f) * viewMatrix(look->camera);
    const auto height = [&seen](const glm::vec3& p) {
      const glm::vec4 clip = seen * glm::vec4(p, 1.0f);
      return clip.y / clip.w;
    };
    QVERIFY(height(femur.low) < -1.0f);
    QVERIFY(std::abs(height(bladder.centre())) < 1.0f);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::OpeningAnatomyTest)
#include "opening_anatomy_test.moc"
