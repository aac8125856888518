// SPDX-License-Identifier: Apache-2.0
// Measures on real anatomy that what opens is a plate (METHOD §12, proof): most of the subject is
// seen, little of the sheet is ink, and some of it has colour.
#include <QFileInfo>
#include <QTest>
#include <cmath>

#include "model/edit/look.h"
#include "model/import/plan/import.h"
#include "model/look/opening_look.h"
#include "render/measures/proof/plate_proof.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {

class OpeningPlateTest : public QObject {
  Q_OBJECT

  static constexpr int width = 1600;
  static constexpr int height = plateHeight;

 private slots:
  // A ball before another, as large as each other and half overlapping: known shares.
  void knownShares() {
    model::Scene scene;
    const auto ball = [&scene](float x, float nearer) {
      model::Style style{.gamma = Gamma::clamped(5.0f), .fill = model::Fill::paper};
      style.colour = Colour{200, 30, 30};
      return scene.append({.name = "ball",
                           .style = style,
                           .mesh = test::moved(*test::sphere(10.0f, 4), 1.0f, {x, -nearer, 0.0f})});
    };
    const model::NodeId behind[] = {ball(0.0f, 0.0f)};
    ball(10.0f, 40.0f);
    model::Camera camera =
        model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 1.0f);
    camera.projection = model::Projection::orthographic;
    camera.target = glm::vec3(0.0f);
    camera.eye = {0.0f, -200.0f, 0.0f};
    camera.heightMm = 50.0f;
    Image picture{.width = 400, .height = 400, .rgba = std::vector<std::uint8_t>(640'000, 255)};
    for (std::size_t i = 0; i < 32'000; i += 4)  // 5 % black,
      picture.rgba[i] = picture.rgba[i + 1] = picture.rgba[i + 2] = 0;
    for (std::size_t i = 32'000; i < 96'000; i += 4)  // 10 % red
      picture.rgba[i + 1] = 100;
    const PlateProof proof = plateProof(scene, camera, behind, picture);
    // Two discs of one radius whose centres are a radius apart share 39.1 % of each.
    QVERIFY2(std::abs(proof.subjectSeen - 0.609) < 0.02,
             qPrintable(QString::number(proof.subjectSeen)));
    QVERIFY(std::abs(proof.ink - 0.05) < 1e-9 && std::abs(proof.coloured - 0.10) < 1e-9);
    QVERIFY(proof.holds());
    const model::Style lines{.fill = model::Fill::none};
    const model::NodeId front[] = {scene.nodes().back().id};
    const model::Scene open = model::withLook(scene, front, lines).scene;
    QCOMPARE(plateProof(open, camera, behind, picture).subjectSeen, 1.0);
    picture.rgba.assign(picture.rgba.size(), 0);
    QVERIFY(!plateProof(open, camera, behind, picture).holds());
  }

  void plates_data() {
    QTest::addColumn<QString>("path");
    QTest::newRow("abdomen") << "abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
    QTest::newRow("label map") << "labelmap/spl_abdomen/spl_abdomen_labels.nrrd";
    QTest::newRow("segmentation") << "labelmap/totalsegmentator/ct_total_labels_3mm.nii.gz";
    QTest::newRow("pelvis") << "pelvis/bodyparts3d";
    QTest::newRow("male pelvis") << "pelvis/hra_vh_male";
    QTest::newRow("protein") << "protein/2src.pdb";
    QTest::newRow("liver vessels") << "misc/bp3d_liver_vessels";
    QTest::newRow("heart") << "misc/hra/VH_F_Heart.glb";
  }
  void plates() {
    QFETCH(QString, path);
    const QString whole = QStringLiteral(SLINE_TEST_DATA "/") + path;
    if (!QFileInfo::exists(whole))
      SLINE_ABSENT("the anatomy is not there");
    const std::filesystem::path paths[] = {whole.toStdString()};
    const auto imported = model::importInputs(paths, {}, {});
    QVERIFY(imported.ok());
    model::FormIndex forms;
    const std::optional<model::OpeningLook> look =
        model::openingLook(imported->scene, forms, {.aspect = float(width) / float(height)});
    QVERIFY(look);
    const Result<PlateProof> proof = plateProof(look->scene, look->camera, look->subject.structures,
                                                float(width) / float(height));
    QVERIFY(proof.ok());
    qInfo("%s: %.0f %% of the subject seen, %.1f %% ink, %.1f %% coloured", qPrintable(path),
          100.0 * proof->subjectSeen, 100.0 * proof->ink, 100.0 * proof->coloured);
    QVERIFY(proof->holds());
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::OpeningPlateTest)
#include "opening_plate_test.moc"
