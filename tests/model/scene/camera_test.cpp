// SPDX-License-Identifier: Apache-2.0
#include "model/scene/camera.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

#include "model/scene/free_sides.h"
#include "tests/support/suite.h"

namespace sline::model {
namespace {

const float nan = std::numeric_limits<float>::quiet_NaN();

Box boxOf(const glm::vec3& low, const glm::vec3& high) {
  Box box;
  box.add(low);
  box.add(high);
  return box;
}

std::vector<glm::vec3> corners(const Box& box) {
  std::vector<glm::vec3> points;
  for (int i = 0; i < 8; ++i)
    points.emplace_back((i & 1) != 0 ? box.high.x : box.low.x,
                        (i & 2) != 0 ? box.high.y : box.low.y,
                        (i & 4) != 0 ? box.high.z : box.low.z);
  return points;
}

/// Returns normalised device coordinates, −1 … 1.
glm::vec3 project(const Camera& camera, const Box& bounds, float aspect, const glm::vec3& p) {
  const glm::vec4 clip =
      projectionMatrix(camera, bounds, aspect) * viewMatrix(camera) * glm::vec4(p, 1.0f);
  return glm::vec3(clip) / clip.w;
}

/// Returns the part of the picture that the points take, in normalised device coordinates.
Box projectedBounds(const Camera& camera, const Box& bounds, float aspect,
                    const std::vector<glm::vec3>& points) {
  Box projected;
  for (const glm::vec3& p : points)
    projected.add(project(camera, bounds, aspect, p));
  return projected;
}

bool close(float a, float b, float tolerance) {
  return std::abs(a - b) <= tolerance;
}
bool close(const glm::vec3& a, const glm::vec3& b, float tolerance) {
  return glm::distance(a, b) <= tolerance;
}

}  // namespace

class CameraTest : public QObject {
  Q_OBJECT

 private slots:
  void viewsShowTheirSide_data();
  void viewsShowTheirSide();
  void fitsBoxWithMargin_data();
  void fitsBoxWithMargin();
  void fitsPointsTighterThanTheirBox();
  void fitsWithinSides_data();
  void fitsWithinSides();
  void fitKeepsDirection();
  void scaledSceneGivesSamePicture_data();
  void scaledSceneGivesSamePicture();
  void depthIsTightAndSound_data();
  void depthIsTightAndSound();
  void degenerateExtentsStaySound_data();
  void degenerateExtentsStaySound();
  void faults_data();
  void faults();
  void pixelSize();
  void directionTowardsEye();
};

void CameraTest::viewsShowTheirSide_data() {
  QTest::addColumn<QString>("view");
  QTest::addColumn<QList<float>>("atRight");  // patient direction on the right of the picture
  QTest::addColumn<QList<float>>("atTop");
  QTest::addColumn<QList<float>>("near");  // the side that is seen
  using L = QList<float>;
  QTest::newRow("anterior") << "anterior" << L{1, 0, 0} << L{0, 0, 1} << L{0, -1, 0};
  QTest::newRow("posterior") << "posterior" << L{-1, 0, 0} << L{0, 0, 1} << L{0, 1, 0};
  QTest::newRow("left") << "left" << L{0, 1, 0} << L{0, 0, 1} << L{1, 0, 0};
  QTest::newRow("right") << "right" << L{0, -1, 0} << L{0, 0, 1} << L{-1, 0, 0};
  QTest::newRow("superior") << "superior" << L{-1, 0, 0} << L{0, -1, 0} << L{0, 0, 1};
  QTest::newRow("inferior") << "inferior" << L{1, 0, 0} << L{0, -1, 0} << L{0, 0, -1};
}

void CameraTest::viewsShowTheirSide() {
  QFETCH(QString, view);
  QFETCH(QList<float>, atRight);
  QFETCH(QList<float>, atTop);
  QFETCH(QList<float>, near);
  const auto vec = [](const QList<float>& v) { return glm::vec3(v[0], v[1], v[2]); };
  const auto named = anatomicalViewNamed(view.toStdString());
  QVERIFY(named.has_value());
  const Box box = boxOf({-100, -60, -200}, {140, 90, 260});
  const Camera camera = anatomicalCamera(*named, box, 1.5f);
  const CameraFrame frame = cameraFrame(camera);
  QVERIFY(close(frame.right, vec(atRight), 1e-6f));
  QVERIFY(close(frame.up, vec(atTop), 1e-6f));
  QVERIFY(close(frame.back, vec(near), 1e-6f));
  // The matrices agree: a step to the patient's side is a step in the picture.
  const glm::vec3 middle = project(camera, box, 1.5f, box.centre());
  QVERIFY(project(camera, box, 1.5f, box.centre() + 5.0f * vec(atRight)).x > middle.x + 1e-3f);
  QVERIFY(project(camera, box, 1.5f, box.centre() + 5.0f * vec(atTop)).y > middle.y + 1e-3f);
  QVERIFY(project(camera, box, 1.5f, box.centre() + 5.0f * vec(near)).z < middle.z);
  QVERIFY(!anatomicalViewNamed("dorsal").has_value());
  // The name is found back from the camera, and after a step aside it is still the nearest.
  QCOMPARE(anatomicalViewOf(camera), named);
  Camera aside = camera;
  aside.eye += 0.3f * glm::length(camera.eye - camera.target) * frame.right;
  QCOMPARE(anatomicalViewOf(aside), std::nullopt);
  QCOMPARE(nearestAnatomicalView(aside), *named);
  Camera rolled = camera;
  rolled.up = frame.right;
  QCOMPARE(anatomicalViewOf(rolled), std::nullopt);
  QCOMPARE(nearestAnatomicalView(rolled), *named);
}

void CameraTest::fitsBoxWithMargin_data() {
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

void CameraTest::fitsBoxWithMargin() {
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

void CameraTest::fitsPointsTighterThanTheirBox() {
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

void CameraTest::fitsWithinSides_data() {
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

void CameraTest::fitsWithinSides() {
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

void CameraTest::fitKeepsDirection() {
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

void CameraTest::scaledSceneGivesSamePicture_data() {
  QTest::addColumn<float>("scale");
  QTest::newRow("metres") << 1e-3f;
  QTest::newRow("micrometres") << 1e3f;
  QTest::newRow("very small") << 1e-12f;
  QTest::newRow("very large") << 1e12f;
}

void CameraTest::scaledSceneGivesSamePicture() {
  QFETCH(float, scale);
  const Box box = boxOf({12, -60, -200}, {140, 90, 260});
  const Box scaled = boxOf(scale * box.low, scale * box.high);
  const std::vector<glm::vec3> points = corners(box);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera = anatomicalCamera(AnatomicalView::left, box, 1.5f);
    camera.projection = projection;
    Camera scaledCamera = anatomicalCamera(AnatomicalView::left, scaled, 1.5f);
    scaledCamera.projection = projection;
    camera = fitted(camera, points, 1.5f);
    scaledCamera = fitted(scaledCamera, corners(scaled), 1.5f);
    QVERIFY(!cameraFault(scaledCamera).has_value());
    for (const glm::vec3& p : points)
      QVERIFY(close(project(camera, box, 1.5f, p), project(scaledCamera, scaled, 1.5f, scale * p),
                    1e-4f));
  }
}

void CameraTest::depthIsTightAndSound_data() {
  QTest::addColumn<float>("eyeY");
  QTest::addColumn<bool>("outside");
  QTest::newRow("far away") << -1e5f << true;
  QTest::newRow("near") << -150.0f << true;
  QTest::newRow("inside") << 0.0f << false;
  QTest::newRow("inside, near the back") << 99.0f << false;
  QTest::newRow("the box behind the eye") << 250.0f << false;
}

void CameraTest::depthIsTightAndSound() {
  QFETCH(float, eyeY);
  QFETCH(bool, outside);
  const Box box = boxOf({-100, -100, -100}, {100, 100, 100});
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera;
    camera.projection = projection;
    camera.eye = {0, eyeY, 0};
    camera.target = {0, eyeY + 100, 0};
    const glm::mat4 matrix = projectionMatrix(camera, box, 1.0f);
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        QVERIFY(std::isfinite(matrix[column][row]));
    // Anything a little before the eye and within the box is drawn.
    if (eyeY < 100.0f) {
      const float z = project(camera, box, 1.0f, {0, std::max(eyeY + 0.5f, -99.0f), 0}).z;
      QVERIFY2(z >= -1.0f && z <= 1.0f, qPrintable(QString::number(double(z))));
      QVERIFY(project(camera, box, 1.0f, {0, 100, 0}).z <= 1.0f);
    }
    if (outside) {  // the box fills the depth range
      QVERIFY(project(camera, box, 1.0f, {0, -100, 0}).z < -0.9f);
      QVERIFY(project(camera, box, 1.0f, {0, 100, 0}).z > 0.9f);
    }
  }
}

void CameraTest::degenerateExtentsStaySound_data() {
  QTest::addColumn<QList<float>>("size");
  QTest::newRow("point") << QList<float>{0, 0, 0};
  QTest::newRow("needle along the line of sight") << QList<float>{0, 50, 0};
  QTest::newRow("needle across") << QList<float>{50, 0, 0};
  QTest::newRow("sheet across") << QList<float>{50, 0, 80};
  QTest::newRow("sheet along") << QList<float>{0, 50, 80};
}

void CameraTest::degenerateExtentsStaySound() {
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

void CameraTest::faults_data() {
  QTest::addColumn<QList<float>>("numbers");  // eye, target, up
  QTest::addColumn<float>("fovy");
  QTest::addColumn<float>("height");
  QTest::addColumn<bool>("orthographic");
  QTest::addColumn<QString>("fault");  // empty: none
  using L = QList<float>;
  const L good{0, -100, 0, 0, 0, 0, 0, 0, 1};
  QTest::newRow("good") << good << 30.0f << 200.0f << false << "";
  QTest::newRow("good orthographic") << good << 30.0f << 200.0f << true << "";
  QTest::newRow("tiny but good") << L{0, -1e-20f, 0, 0, 0, 0, 0, 0, 1e-20f} << 30.0f << 200.0f
                                 << false << "";
  QTest::newRow("widest") << good << 170.0f << 200.0f << false << "";
  QTest::newRow("eye is target") << L{1, 2, 3, 1, 2, 3, 0, 0, 1} << 30.0f << 200.0f << false
                                 << "same point";
  QTest::newRow("up along the sight")
      << L{0, -100, 0, 0, 0, 0, 0, 5, 0} << 30.0f << 200.0f << false << "parallel";
  QTest::newRow("up zero") << L{0, -100, 0, 0, 0, 0, 0, 0, 0} << 30.0f << 200.0f << false
                           << "no length";
  QTest::newRow("NaN eye") << L{nan, -100, 0, 0, 0, 0, 0, 0, 1} << 30.0f << 200.0f << false
                           << "finite";
  QTest::newRow("infinite target")
      << L{0, -100, 0, 0, std::numeric_limits<float>::infinity(), 0, 0, 0, 1} << 30.0f << 200.0f
      << true << "finite";
  QTest::newRow("fovy 0") << good << 0.0f << 200.0f << false << "opening angle";
  QTest::newRow("fovy 171") << good << 171.0f << 200.0f << false << "opening angle";
  QTest::newRow("fovy NaN") << good << nan << 200.0f << false << "opening angle";
  QTest::newRow("fovy is nothing to a parallel camera") << good << nan << 200.0f << true << "";
  QTest::newRow("height 0") << good << 30.0f << 0.0f << true << "height";
  QTest::newRow("height NaN") << good << 30.0f << nan << true << "height";
  QTest::newRow("height is nothing to a perspective camera") << good << 30.0f << nan << false << "";
}

void CameraTest::faults() {
  QFETCH(QList<float>, numbers);
  QFETCH(float, fovy);
  QFETCH(float, height);
  QFETCH(bool, orthographic);
  QFETCH(QString, fault);
  Camera camera;
  camera.projection = orthographic ? Projection::orthographic : Projection::perspective;
  camera.eye = {numbers[0], numbers[1], numbers[2]};
  camera.target = {numbers[3], numbers[4], numbers[5]};
  camera.up = {numbers[6], numbers[7], numbers[8]};
  camera.fovyDegrees = fovy;
  camera.heightMm = height;
  const auto found = cameraFault(camera);
  QCOMPARE(found.has_value(), !fault.isEmpty());
  if (found)
    QVERIFY2(QString::fromUtf8(found->data(), qsizetype(found->size())).contains(fault),
             std::string(*found).c_str());
}

void CameraTest::pixelSize() {
  Camera camera;
  camera.eye = {0, -100, 0};
  camera.fovyDegrees = 90.0f;
  QVERIFY(close(millimetresPerPixel(camera, {7, 0, 9}, 200.0f), 1.0f, 1e-5f));
  QVERIFY(close(millimetresPerPixel(camera, {7, 100, 9}, 200.0f), 2.0f, 1e-5f));
  QCOMPARE(millimetresPerPixel(camera, {0, -200, 0}, 200.0f), 0.0f);
  camera.projection = Projection::orthographic;
  camera.heightMm = 50.0f;
  QVERIFY(close(millimetresPerPixel(camera, {7, 100, 9}, 200.0f), 0.25f, 1e-6f));
}

void CameraTest::directionTowardsEye() {
  Camera camera;
  camera.eye = {0, -100, 0};
  QVERIFY(close(towardsEye(camera, {100, 0, 0}), glm::normalize(glm::vec3(-1, -1, 0)), 1e-6f));
  QVERIFY(close(towardsEye(camera, camera.eye), {0, -1, 0}, 1e-6f));
  camera.projection = Projection::orthographic;
  QVERIFY(close(towardsEye(camera, {100, 0, 0}), {0, -1, 0}, 1e-6f));
}

}  // namespace sline::model

SLINE_TEST(sline::model::CameraTest)
#include "camera_test.moc"
