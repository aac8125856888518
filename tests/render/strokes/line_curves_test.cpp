// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_curves.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "model/geometry/surface.h"
#include "render/lines/techniques/line_technique.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::render {

class LineCurvesTest : public QObject {
  Q_OBJECT

  static constexpr int height = 720;  // one pixel to λ

  /// Returns a view from the front of 100 mm in 720 pixels.
  static PictureView frontView() {
    model::Camera camera{.projection = model::Projection::orthographic,
                         .eye = {0, -200, 0},
                         .target = {0, 0, 0},
                         .up = {0, 0, 1}};
    camera.heightMm = 100.0f;
    model::Box bounds;
    bounds.add(glm::vec3(-60.0f));
    bounds.add(glm::vec3(60.0f));
    return {camera, bounds, height, height};
  }
  static float perMm() { return float(height) / 100.0f; }

  /// Returns segments through the points, mm, in the plane of the picture.
  static std::vector<Segment> through(const std::vector<glm::vec3>& points) {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      segments.push_back(
          {.a = points[i], .b = points[i + 1], .normalA = {0, 0, 1}, .normalB = {0, 0, 1}});
    return segments;
  }
  static std::vector<Segment> curve(const std::vector<Segment>& segments,
                                    const CurveSettings& settings = {}) {
    return curved(segments, connectedChains(segments), frontView(), settings);
  }
  /// Returns the longest move in λ.
  static float farthestMove(const std::vector<Segment>& segments) {
    float most = 0.0f;
    for (const Segment& s : segments)
      most = std::max({most, glm::length(s.moveA), glm::length(s.moveB)});
    return most * perMm();
  }
  static std::vector<Segment> contoursOf(const model::Mesh& mesh) {
    const auto surface = model::prepareSurface(std::make_shared<const model::Mesh>(mesh));
    return extractLines(*surface, frontView().camera(),
                        {.kinds = {LineKind::contour}})[LineKind::contour];
  }

 private slots:
  void zigzagsBecomeStraight() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 120; ++i)
      points.emplace_back(-30.0f + 0.5f * float(i), 0.0f, i % 2 == 0 ? 0.1f : -0.1f);
    const std::vector<Segment> line = curve(through(points));
    for (const Segment& s : line)
      if (std::abs(s.a.x) < 25.0f)
        QVERIFY(std::abs(s.a.z + s.moveA.z) * perMm() < 0.05f);
    QVERIFY(farthestMove(line) <= curveBound);
  }
  void nothingLeavesTheBound_data() {
    QTest::addColumn<bool>("outline");
    QTest::newRow("lines on surfaces") << false;
    QTest::newRow("outlines") << true;
  }
  void nothingLeavesTheBound() {
    QFETCH(bool, outline);
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 200; ++i)
      points.emplace_back(-30.0f + 0.3f * float(i), 0.0f,
                          1.5f * std::sin(0.9f * float(i)) + 0.7f * std::sin(2.3f * float(i)));
    const std::vector<Segment> line = curve(through(points), {.outline = outline});
    QVERIFY(farthestMove(line) <= curveBound + 1e-3f);
    QVERIFY(farthestMove(line) > 0.4f);
    if (!outline)
      return;
    for (const Segment& s : line)
      QVERIFY(s.moveA.z * perMm() <= outlineBound + 1e-3f);  // the normals point upwards
  }
  void outlinesOfRoundFormsStay() {
    for (const float radius : {4.0f, 20.0f}) {
      const std::vector<Segment> ring =
          curve(contoursOf(*test::sphere(radius, 4)), {.outline = true});
      QVERIFY(!ring.empty());
      double drawn = 0.0;
      for (const Segment& s : ring)
        drawn += double(glm::length(s.a + s.moveA - glm::vec3(0, s.a.y, 0)));
      drawn /= double(ring.size());
      QVERIFY2(std::abs(drawn / double(radius) - 1.0) < 0.01,
               qPrintable(QString("%1 of %2 mm").arg(drawn).arg(radius)));
    }
    QVERIFY(farthestMove(curve(contoursOf(*test::torus(24, 8, 90, 40)), {.outline = true})) <=
            curveBound + 1e-3f);
  }
  void cornersStay() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 60; ++i)
      points.emplace_back(-30.0f + 0.5f * float(i), 0.0f, 0.0f);
    for (int i = 1; i <= 60; ++i)
      points.emplace_back(0.0f, 0.0f, 0.5f * float(i));
    float nearest = 1e9f;
    for (const Segment& s : curve(through(points)))
      nearest = std::min(nearest, glm::length(s.b + s.moveB));
    QVERIFY(nearest * perMm() < 0.6f);  // half a step of the samples
  }
  void endsStay() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 50; ++i)
      points.emplace_back(float(i) - 25.0f, 0.0f, 0.4f * std::sin(1.7f * float(i)));
    const std::vector<Segment> line = curve(through(points));
    QCOMPARE(line.front().a, points.front());
    QCOMPARE(line.back().b, points.back());
    QVERIFY(glm::length(line.front().moveA) * perMm() < 0.01f);
    QVERIFY(glm::length(line.back().moveB) * perMm() < 0.01f);
  }
  void withoutSmoothingLinesStay() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 50; ++i)
      points.emplace_back(float(i) - 25.0f, 0.0f, 0.4f * std::sin(1.7f * float(i)));
    QCOMPARE(farthestMove(curve(through(points), {.smoothing = 0.0f})), 0.0f);
  }
  void pressureTellsLightDepthAndEnds() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 50; ++i)
      points.emplace_back(float(i) - 25.0f, 0.0f, 0.0f);
    const auto middleOf = [&](const CurveSettings& settings, float y) {
      std::vector<glm::vec3> moved = points;
      for (glm::vec3& p : moved)
        p.y = y;
      const std::vector<Segment> line = curve(through(moved), settings);
      return line[line.size() / 2].pressureA;
    };
    const CurveSettings lit{.outline = true, .light = {0, 1, 0}};
    const CurveSettings shadowed{.outline = true, .light = {0, -1, 0}};
    QVERIFY(middleOf(shadowed, 0) > 1.5f * middleOf(lit, 0));
    QVERIFY(middleOf({}, -40) > 1.1f * middleOf({}, 40));  // nearer lines are stronger
    const std::vector<Segment> line = curve(through(points));
    QVERIFY(line.front().pressureA < 0.5f * line[line.size() / 2].pressureA);
    for (const Segment& s : curve(through(points), {.variation = 0.0f, .outline = true}))
      QCOMPARE(s.pressureA, 1.0f);
  }
  void joinedPiecesKeepTheCurve() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 300; ++i)
      points.emplace_back(-30.0f + 0.2f * float(i), 0.3f * std::sin(0.7f * float(i)),
                          4.0f * std::sin(0.05f * float(i)));
    const JointLimits joints{.drawn = 0.1f, .line = 0.5f, .depth = 0.2f, .longest = 16.0f};
    const std::vector<Segment> all = curve(through(points));
    const std::vector<Segment> few = curve(through(points), {.joints = joints});
    QVERIFY(3 * few.size() < all.size());
    QCOMPARE(few.front().a, points.front());
    QCOMPARE(few.back().b, points.back());
    std::size_t at = 0;
    for (const Segment& s : all) {
      while (s.a.x >= few[at].b.x && at + 1 < few.size())
        ++at;
      const auto drawn = [](const glm::vec3& p, const glm::vec3& move) {
        return perMm() * glm::vec2(p.x + move.x, p.z + move.z);
      };
      const glm::vec2 from = drawn(few[at].a, few[at].moveA);
      const glm::vec2 way = drawn(few[at].b, few[at].moveB) - from;
      const glm::vec2 off = drawn(s.a, s.moveA) - from;
      QVERIFY(glm::length(way) <= 16.0f);
      QVERIFY(std::abs(way.x * off.y - way.y * off.x) / glm::length(way) <= 0.11f);
      QVERIFY(std::abs(glm::mix(few[at].a.y, few[at].b.y, glm::dot(off, way) / glm::dot(way, way)) -
                       s.a.y) <= 0.21f);
    }
  }
  void joinsAreAlikeInAMirror() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 200; ++i)
      points.emplace_back(-20.0f + 0.2f * float(i), 0.0f, 0.1f * float(i) + std::sin(float(i)));
    const CurveSettings settings{
        .joints = {.drawn = 0.1f, .line = 0.5f, .depth = 1, .longest = 16}};
    const std::vector<Segment> one = curve(through(points), settings);
    std::reverse(points.begin(), points.end());
    for (glm::vec3& p : points)
      p.x = -p.x;
    const std::vector<Segment> other = curve(through(points), settings);
    QCOMPARE(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
      QVERIFY(std::abs(one[i].a.z - other[one.size() - 1 - i].b.z) < 1e-2f);
  }
  void whatIsLookedUpOrFadesLimitsJoints() {
    std::vector<glm::vec3> points;
    for (int i = 0; i <= 100; ++i)
      points.emplace_back(-20.0f + 0.4f * float(i), i % 20 < 10 ? 0.0f : 3.0f, 0.0f);
    const auto pieces = [&](float depth, float opacity) {
      std::vector<Segment> line = through(points);
      for (std::size_t i = 0; i < line.size(); ++i) {
        line[i].opacityA = i % 2 == 0 ? 1.0f : opacity;
        line[i].opacityB = i % 2 == 0 ? opacity : 1.0f;
      }
      return curve(line, {.variation = 0.0f,
                          .joints = {.drawn = 0.1f, .line = 1, .depth = depth, .longest = 16}})
          .size();
    };
    QVERIFY(pieces(0.1f, 1.0f) > pieces(5.0f, 1.0f));
    QVERIFY(pieces(5.0f, 0.5f) > 3 * pieces(5.0f, 1.0f));
  }
  void gapsAreClosedWhereLinesGoOn() {
    const auto row = [](float from, float to, float z = 0.0f) {
      std::vector<glm::vec3> points;
      for (int i = 0; i <= 20; ++i)
        points.emplace_back(from + (to - from) * float(i) / 20.0f, 0.0f, z);
      return through(points);
    };
    const auto chains = [](std::vector<Segment> one, const std::vector<Segment>& other) {
      one.insert(one.end(), other.begin(), other.end());
      return joinedChains(one, frontView()).chains.count();
    };
    const float unit = 1.0f / perMm();
    QCOMPARE(chains(row(-20, 0), row(1.5f * unit, 20)), std::size_t(1));
    QCOMPARE(chains(row(-20, 0), row(3.0f * unit, 20)), std::size_t(2));
    QCOMPARE(chains(row(-20, 0), row(-20, 0, 1.5f * unit)), std::size_t(2));  // side by side
    std::vector<Segment> behind = row(1.5f * unit, 20);
    for (Segment& s : behind)
      s.a.y = s.b.y = 30.0f;
    QCOMPARE(chains(row(-20, 0), behind), std::size_t(2));
  }
};

}  // namespace sline::render

SLINE_TEST(sline::render::LineCurvesTest)
#include "line_curves_test.moc"
