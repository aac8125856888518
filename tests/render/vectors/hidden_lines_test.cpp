// SPDX-License-Identifier: Apache-2.0
// Compares hidden-line removal with rays: every drawn line can be seen, and every line that can be
// seen is drawn.
#include <QtTest>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "model/geometry/spatial_order.h"
#include "render/lines/techniques/visibility.h"
#include "render/vectors/vector_drawing.h"
#include "tests/render/vectors/path_points.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

constexpr glm::vec2 page(160.0f, 90.0f);
constexpr float viewHeight = 60.0f;            // in mm of the scene
constexpr float outputUnit = page.y / 720.0f;  // λ
// A stroke's middle lies half a pen beside its line; curves, pixels and cusps take the rest.
constexpr float near = 2.5f * outputUnit;

model::Camera camera(const glm::vec3& direction) {
  return {.projection = model::Projection::orthographic,
          .eye = 400.0f * glm::normalize(direction),
          .target = {0.0f, 0.0f, 0.0f},
          .up = {0.1f, 0.05f, 1.0f},
          .heightMm = viewHeight};
}

/// Returns a tube along a trefoil knot: it passes before and behind itself.
model::MeshPtr knot(float tube, int along, int around) {
  const auto at = [](double t) {
    return 6.0 * glm::dvec3(std::sin(t) + 2.0 * std::sin(2.0 * t),
                            std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t));
  };
  std::vector<glm::vec3> positions;
  std::vector<model::Triangle> triangles;
  for (int i = 0; i < along; ++i) {
    const double t = glm::two_pi<double>() * i / along;
    const glm::dvec3 tangent = glm::normalize(at(t + 1e-4) - at(t - 1e-4));
    const glm::dvec3 bend = glm::normalize(at(t + 1e-2) + at(t - 1e-2) - 2.0 * at(t));
    const glm::dvec3 side = glm::normalize(glm::cross(tangent, bend));
    const glm::dvec3 up = glm::cross(side, tangent);
    for (int k = 0; k < around; ++k) {
      const double a = glm::two_pi<double>() * k / around;
      positions.emplace_back(at(t) + double(tube) * (std::cos(a) * side + std::sin(a) * up));
    }
  }
  const auto index = [&](int i, int k) { return std::uint32_t((i % along) * around + k % around); };
  for (int i = 0; i < along; ++i)
    for (int k = 0; k < around; ++k) {
      triangles.push_back({index(i, k), index(i + 1, k), index(i + 1, k + 1)});
      triangles.push_back({index(i, k), index(i + 1, k + 1), index(i, k + 1)});
    }
  // The normals face outwards, away from the tube's middle.
  const glm::vec3 a = positions[triangles[0][0]];
  const glm::vec3 normal =
      glm::cross(positions[triangles[0][1]] - a, positions[triangles[0][2]] - a);
  if (glm::dot(normal, a - glm::vec3(at(0.0))) < 0.0f)
    for (model::Triangle& t : triangles)
      std::swap(t[1], t[2]);
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create(std::move(positions), std::move(triangles))).value());
}

model::Scene sceneOf(const std::vector<model::MeshPtr>& meshes, model::Fill fill) {
  model::Scene scene;
  for (const model::MeshPtr& mesh : meshes) {
    model::Node node;
    node.name = "shape";
    node.mesh = mesh;
    node.style.gamma = Gamma::clamped(1.0f);
    node.style.fill = fill;
    scene.append(std::move(node));
  }
  return scene;
}

std::vector<model::MeshPtr> meshesNamed(const QString& name) {
  if (name == "torus")
    return {test::torus(15.0f, 6.0f, 240, 96)};
  if (name == "knot")
    return {knot(2.5f, 600, 48)};
  // One sphere is inside another, a third half behind them.
  return {test::sphere(12.0f, 5), test::sphere(6.0f, 5),
          test::moved(*test::sphere(8.0f, 5), 1.0f, {12.0f, 14.0f, 3.0f})};
}

/// Returns, on the page, the points of all contour segments with middles that rays from the eye
/// reach.
std::vector<glm::vec2> seenByRays(const std::vector<model::MeshPtr>& meshes,
                                  const model::Camera& eye, bool hides) {
  std::vector<std::unique_ptr<model::Bvh>> trees;
  for (const model::MeshPtr& mesh : meshes)
    trees.push_back(std::make_unique<model::Bvh>(mesh, model::spatialOrder(*mesh)));
  const model::CameraFrame frame = model::cameraFrame(eye);
  std::vector<glm::vec2> seen;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const auto surface = model::prepareSurface(meshes[i]);
    const render::LineSet lines = render::extractLines(*surface, eye, {});
    const std::vector<bool> visible =
        render::visibleSegments(*surface, *trees[i], eye, lines[render::LineKind::contour]);
    for (std::size_t k = 0; k < lines[render::LineKind::contour].size(); ++k) {
      const glm::vec3 p =
          0.5f * (lines[render::LineKind::contour][k].a + lines[render::LineKind::contour][k].b);
      bool free = visible[k];
      for (std::size_t other = 0; hides && other < meshes.size(); ++other)
        free =
            free && (other == i || !trees[other]->blocked({.origin = p, .direction = frame.back}));
      const glm::vec3 along =
          lines[render::LineKind::contour][k].b - lines[render::LineKind::contour][k].a;
      const float perMm = page.y / eye.heightMm;
      const int pieces = 1 + int(perMm * glm::length(along) / outputUnit);
      for (int piece = 0; free && piece < pieces; ++piece) {
        const glm::vec3 q =
            lines[render::LineKind::contour][k].a + (float(piece) + 0.5f) / float(pieces) * along;
        seen.push_back(0.5f * page +
                       perMm * glm::vec2(glm::dot(q, frame.right), -glm::dot(q, frame.up)));
      }
    }
  }
  return seen;
}

std::vector<glm::vec2> drawn(const render::VectorDrawing& drawing) {
  std::vector<glm::vec2> points;
  for (const render::VectorStructure& structure : drawing.structures)
    for (const render::VectorLines& lines : structure.lines)
      for (const render::VectorShape& shape : lines.shapes)
        for (const render::Curve& curve : shape.path)
          for (const glm::vec2& p : test::pointsOn(curve, 100))
            points.push_back(p);
  return points;
}

struct Distances {
  float largest = 0.0f;
  double farShare = 0.0;  ///< share of points that have no other near
};
Distances distances(const std::vector<glm::vec2>& from, const std::vector<glm::vec2>& to) {
  Distances found;
  int far = 0;
  for (const glm::vec2& p : from) {
    float squared = 1e9f;
    for (const glm::vec2& q : to)
      squared = std::min(squared, glm::dot(p - q, p - q));
    found.largest = std::max(found.largest, std::sqrt(squared));
    far += std::sqrt(squared) > near;
  }
  found.farShare = double(far) / double(std::max<std::size_t>(from.size(), 1));
  return found;
}

render::VectorDrawing vectors(const model::Scene& scene, const model::Camera& eye) {
  const auto drawing = render::drawVectors(scene, eye, {.sizeMm = page});
  if (!drawing.ok())
    qFatal("%s", drawing.error().text().c_str());
  return *drawing;
}

}  // namespace

class HiddenLinesTest : public QObject {
  Q_OBJECT
 private slots:
  void agreesWithRays_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<glm::vec3>("direction");
    QTest::addColumn<bool>("paper");
    for (const char* name : {"torus", "knot", "spheres"})
      for (const bool paper : {true, false}) {
        const QByteArray title = QByteArray(name) + (paper ? " on paper" : " without fill");
        QTest::newRow(title + ", front") << name << glm::vec3(0.1f, -1.0f, 0.3f) << paper;
        QTest::newRow(title + ", above") << name << glm::vec3(0.5f, -0.4f, 1.0f) << paper;
      }
  }
  void agreesWithRays() {
    QFETCH(QString, name);
    QFETCH(glm::vec3, direction);
    QFETCH(bool, paper);
    const std::vector<model::MeshPtr> meshes = meshesNamed(name);
    const model::Camera eye = camera(direction);
    const model::Scene scene = sceneOf(meshes, paper ? model::Fill::paper : model::Fill::none);
    const std::vector<glm::vec2> ink = drawn(vectors(scene, eye));
    const std::vector<glm::vec2> seen = seenByRays(meshes, eye, paper);
    QVERIFY(ink.size() > 200);
    QVERIFY(seen.size() > 200);
    const Distances hidden = distances(ink, seen);
    const Distances missing = distances(seen, ink);
    qInfo("drawn but hidden: %.2f %%, at most %.1f λ; seen but missing: %.2f %%, at most %.1f λ",
          100.0 * hidden.farShare, double(hidden.largest / outputUnit), 100.0 * missing.farShare,
          double(missing.largest / outputUnit));
    QCOMPARE(hidden.farShare, 0.0);
    QVERIFY(hidden.largest <= 2.5f * outputUnit);
    QCOMPARE(missing.farShare, 0.0);
    QVERIFY(missing.largest <= 2.5f * outputUnit);
  }

  // Fills change how a sphere inside another is drawn.
  void fillsHide_data() {
    QTest::addColumn<int>("fill");
    QTest::addColumn<int>("inner");  // 0 hidden, 1 paler than ink, 2 black
    QTest::newRow("none") << int(model::Fill::none) << 2;
    QTest::newRow("veil") << int(model::Fill::veil) << 1;
    QTest::newRow("tint") << int(model::Fill::tint) << 1;
    QTest::newRow("paper") << int(model::Fill::paper) << 0;
  }
  void fillsHide() {
    QFETCH(int, fill);
    QFETCH(int, inner);
    model::Scene scene =
        sceneOf({test::sphere(12.0f, 4), test::sphere(6.0f, 4)}, model::Fill(fill));
    const render::VectorDrawing drawing = vectors(scene, camera({0.0f, -1.0f, 0.0f}));
    const model::NodeId innerId = scene.nodes().back().id;
    int found = 0;
    for (const render::VectorStructure& structure : drawing.structures)
      for (const render::VectorLines& lines : structure.lines)
        for (const render::VectorShape& shape : lines.shapes) {
          const int grey = (shape.colour.red + shape.colour.green + shape.colour.blue) / 3;
          if (structure.id != innerId)
            QCOMPARE(grey, 0);
          else
            found = grey == 0 ? 2 : 1;
        }
    QCOMPARE(found, inner);
  }

  // Two surfaces that pass through each other all along their outline, as anatomy that is there
  // twice has them: one outline stays of both, without a gap.
  void outlinesOfTwinsAreWhole() {
    constexpr float radius = 12.0f;
    const model::MeshPtr ball = test::sphere(radius, 5);
    std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
    for (glm::vec3& p : positions)
      p *= 1.0f + 0.004f * std::sin(5.0f * std::atan2(p.z, p.x)) * std::sin(0.6f * p.y);
    const auto wavy = std::make_shared<const model::Mesh>(
        model::Mesh::create(std::move(positions),
                            {ball->triangles().begin(), ball->triangles().end()})
            .value());
    const std::vector<glm::vec2> points =
        drawn(vectors(sceneOf({ball, wavy}, model::Fill::paper), camera({0.0f, -1.0f, 0.0f})));
    constexpr int directions = 180;
    std::vector<int> found(directions);
    for (const glm::vec2& p : points) {
      const glm::vec2 away = p - 0.5f * page;
      if (std::abs(glm::length(away) - radius * page.y / viewHeight) < near)
        ++found[std::size_t(float(directions) * (std::atan2(away.y, away.x) / 6.2832f + 0.5f)) %
                directions];
    }
    QCOMPARE(std::count(found.begin(), found.end(), 0), std::ptrdiff_t(0));
  }

  // A section takes the near half away: its lines go, and the inner sphere is seen in the cut one.
  void sectionsOpen() {
    model::Scene scene =
        sceneOf({test::sphere(12.0f, 4), test::sphere(6.0f, 4)}, model::Fill::paper);
    model::Section section;
    section.name = "coronal";
    section.plane = {.normal = {0.0f, -1.0f, 0.0f}, .offset = 0.0f};
    scene.appendSection(section);
    const render::VectorDrawing drawing = vectors(scene, camera({0.0f, -1.0f, 0.0f}));
    int outlines = 0;
    for (const render::VectorStructure& structure : drawing.structures)
      for (const render::VectorLines& lines : structure.lines)
        outlines += QByteArray(lines.kind) == "Cut outlines";
    QCOMPARE(outlines, 2);
  }

  void sameEachTime() {
    const model::Scene scene = sceneOf(meshesNamed("spheres"), model::Fill::veil);
    const auto points = [&] { return drawn(vectors(scene, camera({0.3f, -1.0f, 0.2f}))); };
    QCOMPARE(points(), points());
  }

  void refusesWhatCannotBe() {
    const model::Scene scene = sceneOf(meshesNamed("torus"), model::Fill::none);
    model::Camera eye = camera({0.0f, -1.0f, 0.0f});
    QVERIFY(!render::drawVectors(scene, eye, {.sizeMm = {5.0f, 90.0f}}).ok());
    QVERIFY(!render::drawVectors(scene, eye, {.sizeMm = {160.0f, std::nanf("")}}).ok());
    eye.heightMm = 0.0f;
    QVERIFY(!render::drawVectors(scene, eye, {}).ok());
    // An empty scene is no fault.
    QVERIFY(vectors(model::Scene(), camera({0.0f, -1.0f, 0.0f})).structures.empty());
  }
};

SLINE_TEST(HiddenLinesTest)
#include "hidden_lines_test.moc"
