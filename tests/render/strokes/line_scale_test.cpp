// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/line_scale.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {

class LineScaleTest : public QObject {
  Q_OBJECT

  static PictureView view(float heightMm) {
    model::Camera camera{.projection = model::Projection::orthographic,
                         .eye = {0, -200, 0},
                         .target = {0, 0, 0},
                         .up = {0, 0, 1}};
    camera.heightMm = heightMm;
    model::Box bounds;
    bounds.add(glm::vec3(-60.0f));
    bounds.add(glm::vec3(60.0f));
    return {camera, bounds, 720, 720};
  }
  /// Returns a ball with ripples a few millimetres long.
  static model::SurfacePtr rippled() {
    const model::MeshPtr ball = test::sphere(40.0f, 6);
    std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
    for (glm::vec3& p : positions)
      p *= 1.0f + 0.004f * std::sin(1.5f * p.x) * std::sin(1.5f * p.z);
    return model::prepareSurface(std::make_shared<const model::Mesh>(
        *model::Mesh::create(positions, {ball->triangles().begin(), ball->triangles().end()})));
  }
  static double roughness(const model::Surface& surface) {
    double sum = 0.0;
    for (std::size_t v = 0; v < surface.normals.size(); ++v)
      sum +=
          double(glm::distance(surface.normals[v], glm::normalize(surface.mesh->positions()[v])));
    return sum / double(surface.normals.size());
  }

 private slots:
  void deviationFollowsThePicture() {
    const model::SurfacePtr ball = model::prepareSurface(test::sphere(40.0f, 5));
    QCOMPARE(scaleDeviation(*ball, view(180.0f), 1.0f, 0.0f), 1.0f);  // λ is a quarter millimetre
    QCOMPARE(scaleDeviation(*ball, view(360.0f), 1.0f, 0.0f), 2.0f);
    QCOMPARE(scaleDeviation(*ball, view(180.0f), 0.0f, 0.0f), 0.0f);
    QCOMPARE(scaleDeviation(*ball, view(180.0f), 1.0f, 3.0f), 0.0f);
    QCOMPARE(scaleDeviation(*ball, view(18000.0f), 1.0f, 0.0f), 5.0f);  // an eighth of F
  }
  void nearBySurfacesAreAsMeasured() {
    const model::SurfacePtr ball = rippled();
    LineScales scales;
    for (const float deviation : {0.0f, 0.5f * ball->meanEdge}) {
      const auto shapes = scales.at(ball, deviation);
      QCOMPARE(shapes.size(), std::size_t(1));
      QCOMPARE(shapes.front().surface, ball);
    }
  }
  void farAwaySmallFormsGo() {
    const model::SurfacePtr ball = rippled();
    LineScales scales;
    const auto shapes = scales.at(ball, 4.0f * ball->meanEdge);
    QCOMPARE(shapes.size(), std::size_t(1));
    QCOMPARE(shapes.front().surface->mesh, ball->mesh);
    QVERIFY(roughness(*shapes.front().surface) < 0.3 * roughness(*ball));
    // The same scale is not made twice.
    QCOMPARE(scales.at(ball, 4.0f * ball->meanEdge).front().surface, shapes.front().surface);
  }
  void inAHurryTheNearestScaleStandsIn() {
    const model::SurfacePtr ball = rippled();
    const auto deviation = [&ball](float level) { return ball->meanEdge * std::exp2(level); };
    LineScales scales;
    scales.hurry(true);
    QCOMPARE(scales.at(ball, deviation(2.0f)).front().surface, ball);
    QVERIFY(scales.lacks());
    scales.hurry(false);
    const model::SurfacePtr second = scales.at(ball, deviation(2.0f)).front().surface;
    QVERIFY(second != ball);
    QVERIFY(!scales.lacks());
    scales.hurry(true);
    QCOMPARE(scales.at(ball, deviation(2.0f)).front().surface, second);
    QVERIFY(!scales.lacks());
    const auto third = scales.at(ball, deviation(3.0f));
    QCOMPARE(third.size(), std::size_t(1));
    QCOMPARE(third.front().surface, second);
    QCOMPARE(third.front().share, 1.0f);
    QCOMPARE(scales.at(ball, deviation(0.8f)).front().surface, ball);
    QVERIFY(scales.lacks());
    scales.hurry(false);
    QVERIFY(scales.at(ball, deviation(3.0f)).front().surface != second);
  }
  void scalesGiveWayToEachOther() {
    const model::SurfacePtr ball = rippled();
    LineScales scales;
    for (float at = 0.4f; at < 2.3f; at += 0.1f) {
      float sum = 0.0f;
      for (const ScaledShape& shape : scales.at(ball, ball->meanEdge * std::exp2(at)))
        sum += shape.share;
      QVERIFY(std::abs(sum - 1.0f) < 1e-5f);
    }
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::LineScaleTest)
#include "line_scale_test.moc"
