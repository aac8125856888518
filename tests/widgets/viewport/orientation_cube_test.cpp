// SPDX-License-Identifier: Apache-2.0
// Tests that the cube never swaps left and right: its letters stand where the renderer draws those
// sides.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>

#include "model/camera/camera_moves.h"
#include "render/labels/orientation_letters.h"
#include "tests/support/suite.h"
#include "widgets/viewport/orientation_cube.h"

using namespace sline;
using namespace sline::widgets;

namespace {

glm::vec3 sideOf(char letter) {
  switch (letter) {
    case 'L':
      return {1, 0, 0};
    case 'R':
      return {-1, 0, 0};
    case 'P':
      return {0, 1, 0};
    case 'A':
      return {0, -1, 0};
    case 'S':
      return {0, 0, 1};
    default:
      return {0, 0, -1};
  }
}

glm::vec3 alongAxis(const std::string& axis) {
  glm::vec3 direction(0.0f);
  direction[glm::length_t(axis.back() - 'X')] = axis.size() > 1 ? -1.0f : 1.0f;
  return direction;
}

model::Camera oblique(float turn, float tilt) {
  model::Camera camera = model::anatomicalCamera(model::AnatomicalView::anterior, {}, 1.0f);
  camera.projection = model::Projection::orthographic;
  return orbited(camera, {}, turn, tilt);
}

float cross(const glm::vec2& a, const glm::vec2& b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace

class OrientationCubeTest : public QObject {
  Q_OBJECT
 private slots:
  /// Each anatomical view shows its own face, with its letter upright; the letters at the picture's
  /// edges name the faces beside it.
  void anatomicalViews_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<char>("letter");
    using enum model::AnatomicalView;
    QTest::newRow("anterior") << int(anterior) << 'A';
    QTest::newRow("posterior") << int(posterior) << 'P';
    QTest::newRow("left") << int(left) << 'L';
    QTest::newRow("right") << int(right) << 'R';
    QTest::newRow("superior") << int(superior) << 'S';
    QTest::newRow("inferior") << int(inferior) << 'I';
  }
  void anatomicalViews() {
    QFETCH(int, view);
    QFETCH(char, letter);
    const model::Camera camera = model::anatomicalCamera(model::AnatomicalView(view), {}, 1.0f);
    const std::vector<CubeFace> faces = cubeFaces(camera, 30.0f);
    QCOMPARE(faces.size(), std::size_t(1));
    QCOMPARE(faces[0].letter, letter);
    QVERIFY(glm::length(faces[0].right - glm::vec2(30, 0)) < 1e-3f);
    QVERIFY(glm::length(faces[0].up - glm::vec2(0, -30)) < 1e-3f);
    // A click on the face changes only the pivot's place; a click on its right edge brings to the
    // front the side that stands at the picture's right edge.
    QVERIFY(*cubeDirectionAt(faces, {2, 3}) == CubeDirection(sideOf(letter)));
    const CubeDirection edge = *cubeDirectionAt(faces, {27, 0});
    const char right = render::edgeLetters(camera, {}).right.front();
    QVERIFY(edge == CubeDirection(sideOf(letter) + sideOf(right)));
    const model::Camera again =
        turnedTo(camera, {}, glm::vec3(faces[0].part), upwardsFrom(faces[0].part));
    QVERIFY(render::edgeLetters(again, {}) == render::edgeLetters(camera, {}));
  }

  /// The cube is right-handed for every camera: letters are never seen from behind, and stand in
  /// the direction in which the renderer's projection puts their side.
  void neverMirrored() {
    for (int turn = -180; turn < 180; turn += 23)
      for (int tilt = -80; tilt <= 80; tilt += 16) {
        const model::Camera camera = oblique(float(turn), float(tilt));
        const std::vector<CubeFace> faces = cubeFaces(camera, 30.0f);
        QVERIFY(!faces.empty() && faces.size() <= 3);
        for (const CubeFace& face : faces) {
          QVERIFY(glm::vec3(face.part) == sideOf(face.letter));
          QVERIFY(glm::vec3(face.part) == alongAxis(axisOf(face.part)));
          QVERIFY(cross(face.right, face.up) < 0.0f);  // y goes down
          const glm::vec2 size(100.0f, 100.0f);
          const glm::vec2 drawn = *pixelOf(camera, sideOf(face.letter), size) - 0.5f * size;
          if (glm::length(drawn) < 0.02f)
            continue;  // straight ahead
          QVERIFY(std::abs(cross(glm::normalize(drawn), face.centre)) < 0.05f);
          QVERIFY(glm::dot(drawn, face.centre) >= 0.0f);
        }
      }
  }

  /// Every part that is seen can be hit, and leads to a view in which it faces the eye.
  void partsLeadToTheirViews() {
    const std::vector<CubeFace> faces = cubeFaces(oblique(-35.0f, 30.0f), 30.0f);
    int seen = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const CubeDirection part(x, y, z);
          const auto patches = cubePatches(faces, part);
          for (const auto& patch : patches) {
            const glm::vec2 middle = 0.25f * (patch[0] + patch[1] + patch[2] + patch[3]);
            QVERIFY(*cubeDirectionAt(faces, middle) == part);
          }
          if (patches.empty())
            continue;
          ++seen;
          const model::Camera there =
              turnedTo(oblique(50.0f, 5.0f), {1, 2, 3}, glm::vec3(part), upwardsFrom(part));
          QVERIFY(!model::cameraFault(there));
          QVERIFY(glm::dot(model::cameraFrame(there).back, glm::normalize(glm::vec3(part))) >
                  0.9999f);
        }
    QCOMPARE(seen, 3 + 9 + 7);  // faces, edges and corners of a cube seen from a corner
    QVERIFY(!cubeDirectionAt(faces, {70, 70}));
  }
};

SLINE_TEST(OrientationCubeTest)
#include "orientation_cube_test.moc"
