// SPDX-License-Identifier: Apache-2.0
// Tests cameras that are fitted to boxes and points.
#include "model/camera/camera.h"

#include <QTest>
#include <array>
#include <glm/geometric.hpp>
#include <random>

#include "model/camera/free_sides.h"
#include "model/camera/outermost_points.h"
#include "model/scene/framing.h"
#include "tests/model/scene/projected_boxes.h"
#include "tests/support/suite.h"

namespace sline::model {

using namespace test;

namespace {

/// Returns the part of the picture that the points take, in normalised device coordinates.
Box projectedBounds(const Camera& camera, const Box& bounds, float aspect,
                    const std::vector<glm::vec3>& points) {
  Box projected;
  for (const glm::vec3& p : points)
    projected.add(project(camera, bounds, aspect, p));
  return projected;
}

PointCloud cloudOf(const std::vector<glm::vec3>& points) {
  Box box;
  for (const glm::vec3& p : points)
    box.add(p);
  return {points, box};
}

}  // namespace

class CameraFitTest : public QObject {
  Q_OBJECT

 private slots:
  void fitsBoxWithMargin_data();
  void fitsBoxWithMargin();
  void fitsPointsTighterThanTheirBox();
  void innerPointsDoNotMatter();
  void fitsWithinSides_data();
  void fitsWithinSides();
  void roomAtTheSidesKeepsThePerspective_data();
  void roomAtTheSidesKeepsThePerspective();
  void fitKeepsDirection();
  void degenerateExtentsStaySound_data();
  void degenerateExtentsStaySound();
};

void CameraFitTest::fitsBoxWithMargin_data() {
  QTest::addColumn<int>("view");
  QTest::addColumn<float>("aspect");
  QTest::addColumn<float>("fovy");
  QTest::addColumn<bool>("orthographic");
  for (int view = 0; view < 6; ++view)
    for (const float aspect : {0.5f, 1.0f, 16.0f / 9.0f})
      for (const float fovy : {10.0f, 30.0f, 90.0f})
        for (const bool orthographic : {false, true})
          QTest::addRow("%d aspect %.2f fovy %.0f %s", view, double(aspect), double(fovy),
                        orthographic ? "orthographic" : "perspective")
              << view << aspect << fovy << orthographic;
}

void CameraFitTest::fitsBoxWithMargin() {
  QFETCH(int, view);
  QFETCH(float, aspect);
  QFETCH(float, fovy);
  QFETCH(bool, orthographic);
  const Box box = boxOf({12, -60, -200}, {140, 90, 260});
  Camera camera = anatomicalCamera(AnatomicalView(view), box, aspect);
  camera.fovyDegrees = fovy;
  camera.projection = orthographic ? Projection::orthographic : Projection::perspective;
  camera = fitted(camera, corners(box), aspect);
  QVERIFY(!cameraFault(camera).has_value());

  const Box seen = projectedBounds(camera, box, aspect, corners(box));
  const float tightest = std::max({-seen.low.x, seen.high.x, -seen.low.y, seen.high.y});
  QVERIFY2(close(tightest, 0.9f, 2e-4f), qPrintable(QString::number(double(tightest))));
  QVERIFY2(close(seen.low.x, -seen.high.x, 2e-4f), "centred left to right");
  QVERIFY2(close(seen.low.y, -seen.high.y, 2e-4f), "centred bottom to top");
  QVERIFY(seen.low.z >= -1.0f && seen.high.z <= 1.0f);
}

void CameraFitTest::fitsPointsTighterThanTheirBox() {
  // There is a needle from corner to corner and one point beside it: the box is much larger than
  // they are.
  std::vector<glm::vec3> points;
  for (int i = 0; i <= 20; ++i)
    points.emplace_back(10.0f * float(i), 5.0f * float(i), 7.0f * float(i));
  points.emplace_back(30.0f, 0.0f, 90.0f);
  Box box;
  for (const glm::vec3& p : points)
    box.add(p);
  const float aspect = 1.2f;
  Camera camera;
  camera.eye = {300, -400, 200};
  camera.target = {0, 0, 0};
  camera = fitted(camera, points, aspect);
  const Box seen = projectedBounds(camera, box, aspect, points);
  QVERIFY(close(std::max({-seen.low.x, seen.high.x, -seen.low.y, seen.high.y}), 0.9f, 2e-4f));
  QVERIFY(close(seen.low.x, -seen.high.x, 2e-4f));
  QVERIFY(close(seen.low.y, -seen.high.y, 2e-4f));
}

/// Points on an askew ellipsoid decide, to the last bit, not the many within; nor do one or two
/// points that all lie at one place.
void CameraFitTest::innerPointsDoNotMatter() {
  std::mt19937 chance(7);
  std::normal_distribution<float> normal;
  std::vector<glm::vec3> outer;
  std::vector<glm::vec3> all;
  std::vector<glm::vec3> inner;
  for (int i = 0; i < 4000; ++i) {
    const glm::vec3 way = glm::normalize(glm::vec3(normal(chance), normal(chance), normal(chance)));
    const glm::vec3 p(120.0f * way.x + 30.0f * way.z, 60.0f * way.y - 20.0f * way.x, 90.0f * way.z);
    outer.push_back(p);
    all.push_back(p);
    all.push_back(0.9f * p);
    all.push_back(0.2f * p);
    inner.push_back(0.3f * p);
  }
  for (const float aspect : {0.7f, 1.6f}) {
    Camera camera;
    camera.eye = {300, -400, 200};
    camera.target = {10, 0, 0};
    camera.projection = Projection::perspective;
    QVERIFY(fitted(camera, all, aspect) == fitted(camera, outer, aspect));
    const std::array clouds{cloudOf(outer), cloudOf(all), cloudOf(inner)};
    const std::vector<glm::vec3> outermost = outermostPoints(camera, clouds);
    QVERIFY2(outermost.size() < 2 * outer.size(), qPrintable(QString::number(outermost.size())));
    QVERIFY(fitted(camera, outermost, aspect) == fitted(camera, all, aspect));
    const std::vector<glm::vec3> one{{5.0f, 6.0f, 7.0f}};
    const std::vector<glm::vec3> twice{one.front(), one.front()};
    QVERIFY(fitted(camera, one, aspect) == fitted(camera, twice, aspect));
  }
}

void CameraFitTest::fitsWithinSides_data() {
  QTest::addColumn<QList<double>>("sides");  // left, right, top, bottom
  QTest::addColumn<bool>("orthographic");
  for (const bool orthographic : {false, true}) {
    const char* how = orthographic ? "orthographic" : "perspective";
    QTest::addRow("as usual, %s", how) << QList{0.05, 0.05, 0.05, 0.05} << orthographic;
    QTest::addRow("wide at the left, %s", how) << QList{0.3, 0.1, 0.02, 0.02} << orthographic;
    QTest::addRow("all in the right half, %s", how) << QList{0.55, 0.05, 0.2, 0.02} << orthographic;
    QTest::addRow("low and at the left, %s", how) << QList{0.02, 0.4, 0.6, 0.02} << orthographic;
  }
}

void CameraFitTest::fitsWithinSides() {
  QFETCH(QList<double>, sides);
  QFETCH(bool, orthographic);
  const Box box = boxOf({12, -60, -200}, {140, 90, 260});
  const float aspect = 1.4f;
  Camera camera = anatomicalCamera(AnatomicalView::anterior, box, aspect);
  camera.projection = orthographic ? Projection::orthographic : Projection::perspective;
  const CameraFrame before = cameraFrame(camera);
  camera = fitted(camera, corners(box), aspect,
                  {.left = sides[0], .right = sides[1], .top = sides[2], .bottom = sides[3]});
  QVERIFY(close(cameraFrame(camera).back, before.back, 1e-6f));
  const Box seen = projectedBounds(camera, box, aspect, corners(box));
  // This is the space left beyond the sides, in halves of the picture.
  const float left = seen.low.x + 1.0f - 2.0f * float(sides[0]);
  const float right = 1.0f - seen.high.x - 2.0f * float(sides[1]);
  const float top = 1.0f - seen.high.y - 2.0f * float(sides[2]);
  const float bottom = seen.low.y + 1.0f - 2.0f * float(sides[3]);
  QVERIFY(close(left, right, 1e-3f));
  QVERIFY(close(top, bottom, 1e-3f));
  QVERIFY(close(std::min(left, top), 0.0f, 1e-3f));
}

void CameraFitTest::roomAtTheSidesKeepsThePerspective_data() {
  QTest::addColumn<float>("aspect");
  QTest::addColumn<float>("side");
  QTest::addColumn<bool>("kept");
  QTest::newRow("as saved") << 4.0f / 3.0f << 0.05f << true;
  QTest::newRow("wide") << 1.6f << 0.1f << true;
  QTest::newRow("labels") << 1.6f << 0.25f << true;
  QTest::newRow("narrow") << 0.8f << 0.2f << true;
  QTest::newRow("beyond what may be opened") << 0.5f << 0.4f << false;
}

/// A view with labels beside it shows what it showed when it was saved, smaller; what lies at the
/// sides of the saved picture lies at the same share of what is left.
void CameraFitTest::roomAtTheSidesKeepsThePerspective() {
  QFETCH(float, aspect);
  QFETCH(float, side);
  QFETCH(bool, kept);
  const Camera saved{.eye = {0, -500, 0}, .target = {0, 0, 0}};
  const Camera wider = withSides(saved, aspect, {.left = side, .right = side});
  QVERIFY(!cameraFault(wider));
  QCOMPARE(wider.eye == saved.eye, kept);
  const glm::vec3 atEdge{0.9f * 4.0f / 3.0f * 500.0f * edgeSlope(saved), 0, 0};
  const Box bounds{{-500, -100, -100}, {500, 100, 100}};
  const float x = project(wider, bounds, aspect, atEdge).x;
  QVERIFY2(std::abs(x) <= 1.0f - 2.0f * side + 1e-3f, qPrintable(QString::number(x)));
  for (const float y : {-80.0f, 80.0f}) {
    const glm::vec3 p{60, y, 30};
    const glm::vec3 now = project(wider, bounds, aspect, p);
    const glm::vec3 then = project(saved, bounds, aspect, p);
    if (kept)  // the same picture, smaller
      QVERIFY(std::abs(now.x * then.y - now.y * then.x) < 1e-4f);
  }
}

void CameraFitTest::fitKeepsDirection() {
  Camera camera;
  camera.eye = {300, -400, 200};
  camera.target = {1, 2, 3};
  camera.up = {0.1f, 0.2f, 1.0f};
  const CameraFrame before = cameraFrame(camera);
  const Camera after = fitted(camera, corners(boxOf({-5, -6, -7}, {50, 60, 70})), 1.0f);
  const CameraFrame frame = cameraFrame(after);
  QVERIFY(close(before.right, frame.right, 1e-5f));
  QVERIFY(close(before.up, frame.up, 1e-5f));
  QVERIFY(close(before.back, frame.back, 1e-5f));
  QCOMPARE(after.fovyDegrees, camera.fovyDegrees);
  QCOMPARE(fitted(camera, {}, 1.0f), camera);
}

void CameraFitTest::degenerateExtentsStaySound_data() {
  QTest::addColumn<QList<float>>("size");
  QTest::newRow("point") << QList<float>{0, 0, 0};
  QTest::newRow("needle along the line of sight") << QList<float>{0, 50, 0};
  QTest::newRow("needle across") << QList<float>{50, 0, 0};
  QTest::newRow("sheet across") << QList<float>{50, 0, 80};
  QTest::newRow("sheet along") << QList<float>{0, 50, 80};
}

void CameraFitTest::degenerateExtentsStaySound() {
  QFETCH(QList<float>, size);
  const glm::vec3 low(1000, 2000, -3000);
  const Box box = boxOf(low, low + glm::vec3(size[0], size[1], size[2]));
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = anatomicalCamera(AnatomicalView::anterior, box, 1.3f);
    camera.projection = projection;
    camera = fitted(camera, corners(box), 1.3f);
    QVERIFY(!cameraFault(camera).has_value());
    const Box seen = projectedBounds(camera, box, 1.3f, corners(box));
    QVERIFY(seen.low.x >= -0.91f && seen.high.x <= 0.91f);
    QVERIFY(seen.low.y >= -0.91f && seen.high.y <= 0.91f);
    QVERIFY(seen.low.z >= -1.0f && seen.high.z <= 1.0f);
  }
}

}  // namespace sline::model

SLINE_TEST(sline::model::CameraFitTest)
#include "camera_fit_test.moc"
