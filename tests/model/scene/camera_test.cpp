// SPDX-License-Identifier: Apache-2.0
// Tests cameras: what they show, at what scale and depth, and their faults.
#include "model/camera/camera.h"

#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

#include "model/camera/free_sides.h"
#include "tests/model/scene/projected_boxes.h"
#include "tests/support/suite.h"

namespace sline::model {

using namespace test;

namespace {

const float nan = std::numeric_limits<float>::quiet_NaN();

}  // namespace

class CameraTest : public QObject {
  Q_OBJECT

 private slots:
  void viewsShowTheirSide_data();
  void viewsShowTheirSide();
  void scaledSceneGivesSamePicture_data();
  void scaledSceneGivesSamePicture();
  void depthIsTightAndSound_data();
  void depthIsTightAndSound();
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

void CameraTest::scaledSceneGivesSamePicture_data() {
  QTest::addColumn<float>("scale");
  QTest::newRow("metres") << 1e-3f;
  QTest::newRow("micrometres") << 1e3f;
  QTest::newRow("very small") << 1e-12f;
  QTest::newRow("very large") << 1e5f;
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
  QTest::newRow("as far as may be")
      << L{0, -1e11f, 0, 0, 0, 0, 0, 0, 1} << 30.0f << 200.0f << false << "";
  QTest::newRow("eye far away") << L{3.4e38f, -3.4e38f, 0, 0, 0, 0, 0, 0, 1} << 30.0f << 200.0f
                                << false << "100,000 km";
  QTest::newRow("target far away")
      << L{0, 0, 0, 0, 0, 2e11f, 0, 1, 0} << 30.0f << 200.0f << true << "100,000 km";
  QTest::newRow("height below all rounding") << good << 30.0f << 1e-30f << true << "too small";
  QTest::newRow("as low as may be") << good << 30.0f << 1.1e-4f << true << "";
  QTest::newRow("height beyond the eye's reach") << good << 30.0f << 2e11f << true << "too large";
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
