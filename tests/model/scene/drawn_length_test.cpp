// SPDX-License-Identifier: Apache-2.0
// Tests what is written of a distance between two structures, from bodies to cells.
#include <QTest>

#include "model/lengths/shortest_distance.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class DrawnLengthTest : public QObject {
  Q_OBJECT

 private slots:
  void lengths_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("gap");
    QTest::addColumn<bool>("touching");
    QTest::newRow("kidneys") << 30.0 << 12.0 << false;
    QTest::newRow("kidneys that touch") << 30.0 << 0.02 << true;
    QTest::newRow("small lesions") << 2.0 << 0.02 << false;
    QTest::newRow("organelles") << 0.005 << 0.0038 << false;
    QTest::newRow("organelles that touch") << 0.005 << 1e-6 << true;
    // A pelvis in metres that nobody has scaled.
    QTest::newRow("a bladder of 0.05 mm") << 0.05 << 0.045 << false;
  }
  void lengths() {
    QFETCH(double, radius);
    QFETCH(double, gap);
    QFETCH(bool, touching);
    Scene scene;
    const auto ball = [&](const char* name, double x) {
      Node node{.name = name};
      node.mesh = test::moved(*test::sphere(1.0f, 3), float(radius), {float(x), 0.0f, 0.0f});
      return scene.append(std::move(node));
    };
    const NodeId first = ball("first", 0.0);
    const NodeId second = ball("second", 2.0 * radius + gap);
    const std::optional<Annotation> distance = shortestDistance(scene, first, second);
    QVERIFY(distance);
    const std::optional<DrawnLength> length = drawnLength(scene, *distance);
    QVERIFY(length);
    QCOMPARE(length->offMm, 0.0f);
    if (touching)
      QCOMPARE(length->mm, 0.0f);
    else
      QVERIFY2(std::abs(double(length->mm) - gap) < 0.02 * radius,
               qPrintable(QString::number(double(length->mm))));
  }
  void onlyOfDistances() {
    Scene scene;
    QVERIFY(!drawnLength(scene, {.kind = AnnotationKind::pin, .anchors = {glm::vec3(0.0f)}}));
    const Annotation free{.kind = AnnotationKind::distance,
                          .anchors = {glm::vec3(0.0f), glm::vec3(0.0f, 3.0f, 4.0f)}};
    QCOMPARE(drawnLength(scene, free)->mm, 5.0f);
    QCOMPARE(drawnLength(scene, free)->offMm, 0.0f);
  }
  /// Import has smoothed the one surface and simplified the other.
  void surfacesThatWereMoved() {
    Scene scene;
    Node smoothed{.name = "tumour", .mesh = test::sphere(10.0f, 3)};
    smoothed.provenance.smoothingSteps = 12;
    smoothed.provenance.displacementMm = 0.7f;
    Node simplified{.name = "vein"};
    simplified.mesh = test::moved(*test::sphere(1.0f, 3), 4.0f, {20.0f, 0.0f, 0.0f});
    simplified.provenance.decimatedFrom = 9000;
    simplified.provenance.decimationMm = 0.1f;
    const NodeId first = scene.append(std::move(smoothed));
    const NodeId second = scene.append(std::move(simplified));
    const std::optional<Annotation> distance = shortestDistance(scene, first, second);
    QVERIFY(distance);
    QVERIFY(std::abs(drawnLength(scene, *distance)->offMm - 0.8f) < 1e-6f);
  }
};

SLINE_TEST(DrawnLengthTest)
#include "drawn_length_test.moc"
