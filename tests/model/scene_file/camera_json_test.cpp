// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/camera_json.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::model {

class CameraJsonTest : public QObject {
  Q_OBJECT

 private slots:
  void reads();
  void readsWhatIsWritten();
  void refuses_data();
  void refuses();
};

void CameraJsonTest::reads() {
  const auto camera =
      parseCamera(R"({"projection":"perspective","eye":[1,-2.5,3e2],"target":[4,5,6],"up":[0,1,1],)"
                  R"("fovy_deg":45})");
  QVERIFY(camera.ok());
  QVERIFY(camera->projection == Projection::perspective);
  QVERIFY(camera->eye == glm::vec3(1.0f, -2.5f, 300.0f));
  QVERIFY(camera->target == glm::vec3(4.0f, 5.0f, 6.0f));
  QVERIFY(camera->up == glm::vec3(0.0f, 1.0f, 1.0f));
  QCOMPARE(camera->fovyDegrees, 45.0f);
  const auto parallel = parseCamera(
      R"({"projection":"orthographic","eye":[0,-1,0],"target":[0,0,0],"height_mm":120})");
  QVERIFY(parallel.ok());
  QVERIFY(parallel->projection == Projection::orthographic);
  QCOMPARE(parallel->heightMm, 120.0f);
}

void CameraJsonTest::readsWhatIsWritten() {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera written{.projection = projection,
                         .eye = {0.1f, -250.0f, 3.0f},
                         .target = {1.0f, 2.0f, 3.0f},
                         .up = {0.0f, 0.6f, 0.8f},
                         .fovyDegrees = 33.3f,
                         .heightMm = 120.7f};
    const auto read = parseCamera(cameraJson(written).dump());
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QVERIFY(*read == written);
  }
}

void CameraJsonTest::refuses_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QString>("says");
  QTest::newRow("empty") << ""
                         << "JSON";
  QTest::newRow("cut off") << R"({"eye":[0,-1,0],"target":[0)"
                           << "byte";
  QTest::newRow("a list") << "[1,2]"
                          << "object";
  QTest::newRow("no eye") << R"({"target":[0,0,0]})"
                          << R"("eye_mm" is missing)";
  QTest::newRow("two numbers") << R"({"eye":[0,1],"target":[0,0,0]})"
                               << "three numbers";
  QTest::newRow("a word") << R"({"eye":[0,1,"x"],"target":[0,0,0]})"
                          << "a number is expected";
  QTest::newRow("a number too large") << R"({"eye":[0,1,1e300],"target":[0,0,0]})"
                                      << "eye";
  QTest::newRow("far too large") << R"({"eye":[0,1,1e999],"target":[0,0,0]})"
                                 << "JSON";
  QTest::newRow("unknown key") << R"({"eye":[0,1,0],"target":[0,0,0],"fov":3})"
                               << "fov";
  QTest::newRow("unknown projection")
      << R"({"projection":"fisheye","eye":[0,1,0],"target":[0,0,0]})"
      << "orthographic";
  QTest::newRow("projection of a number") << R"({"projection":1,"eye":[0,1,0],"target":[0,0,0]})"
                                          << "projection";
  QTest::newRow("parallel without height")
      << R"({"projection":"orthographic","eye":[0,1,0],"target":[0,0,0]})"
      << "height_mm";
  QTest::newRow("opening too wide") << R"({"eye":[0,1,0],"target":[0,0,0],"fovy_deg":175})"
                                    << "170";
  QTest::newRow("blind") << R"({"eye":[0,1,0],"target":[0,1,0]})"
                         << "same point";
  QTest::newRow("deeply nested") << QString("[").repeated(100000) << "";
}

void CameraJsonTest::refuses() {
  QFETCH(QString, text);
  QFETCH(QString, says);
  const auto camera = parseCamera(text.toStdString());
  QVERIFY(!camera.ok());
  const std::string message = camera.error().text();
  QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
}

}  // namespace sline::model

SLINE_TEST(sline::model::CameraJsonTest)
#include "camera_json_test.moc"
