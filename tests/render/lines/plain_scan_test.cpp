// SPDX-License-Identifier: Apache-2.0
// Compares contours and suggestive contours with those of a plain scan, which looks at every
// triangle and knows of no clusters: they must be the same, to the last bit.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "render/lines/ground/line_clip.h"
#include "render/lines/ground/view_fields.h"
#include "render/lines/hatching/clipping.h"
#include "render/lines/techniques/lines.h"
#include "render/lines/techniques/rims.h"
#include "render/lines/techniques/suggestive_contours.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

/// A vertex as the eye sees it.
struct Seen {
  float facing;
  float nv;
  float bending;
  float curvature;
  float derivative;  ///< Dκr·F²
};

/// Looks at every vertex and every triangle.
class PlainScan {
 public:
  PlainScan(const model::Surface& surface, const model::Camera& camera,
            const render::LineRequest& request)
      : m_surface(surface), m_request(request) {
    const model::EyePoint eye = render::eyeOf(camera);
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
      const model::SurfaceVertex& v = surface.vertices[i];
      const glm::vec3 d = render::vectorTo(eye, v.position);
      const float facing = glm::dot(v.normal, d);
      const float nv = render::cosineOf(facing, glm::dot(d, d));
      m_seen.push_back(
          {facing, nv, render::bendingTowards(v.normal, v.e1, v.k, d),
           render::radialCurvatureTowards(v.normal, v.e1, v.k, d),
           surface.featureSize * surface.featureSize *
               render::radialCurvatureDerivative(
                   v.k, v.derivative, render::viewInPrincipalFrame(v.normal, v.e1, d), nv)});
    }
  }

  std::vector<render::Segment> contours() const {
    std::vector<render::Segment> found;
    const model::Camera camera;
    render::findRims({m_surface, camera, m_request, render::prepareRims(m_surface).get()}, found);
    forEachCrossed(&Seen::facing, &Seen::nv, [&](std::uint32_t triangle, const auto& ends) {
      found.push_back({.a = ends[0].position, .b = ends[1].position, .triangle = triangle});
    });
    return found;
  }

  std::vector<render::Segment> suggestive() const {
    std::vector<render::Segment> found;
    const float least =
        m_request.thresholds.of(render::LineKind::suggestive, render::leastDerivative);
    const float cosine =
        std::cos(m_request.thresholds.of(render::LineKind::suggestive, render::leastAngle));
    forEachCrossed(&Seen::bending, &Seen::curvature, [&](std::uint32_t triangle, const auto& c) {
      for (const float side : {1.0f, -1.0f}) {
        if (side < 0.0f && !m_request.twoSided)
          continue;
        std::array<float, 2> range{0.0f, 1.0f};
        render::keepWherePositive(side * c[0].nv, side * c[1].nv, range);
        render::keepWherePositive(cosine - side * c[0].nv, cosine - side * c[1].nv, range);
        render::keepWherePositive(side * c[0].strength - least, side * c[1].strength - least,
                                  range);
        if (range[0] < range[1])
          found.push_back({.a = between(c[0].position, c[1].position, range[0]),
                           .b = between(c[0].position, c[1].position, range[1]),
                           .triangle = triangle});
      }
    });
    return found;
  }

 private:
  static glm::vec3 between(const glm::vec3& a, const glm::vec3& b, float t) {
    return t >= 1.0f ? b : a + t * (b - a);
  }

  render::LineEnd endOn(std::uint32_t a, std::uint32_t b, float Seen::*value) const {
    if (b < a)
      std::swap(a, b);
    const Seen& atA = m_seen[a];
    const Seen& atB = m_seen[b];
    const float t = std::clamp(atA.*value / (atA.*value - atB.*value), 0.0f, 1.0f);
    const auto mix = [t](const auto& x, const auto& y) { return x + t * (y - x); };
    const auto p = m_surface.mesh->positions();
    return {.position = mix(p[a], p[b]),
            .nv = mix(atA.nv, atB.nv),
            .strength = mix(atA.derivative, atB.derivative)};
  }

  template <class Body>
  void forEachCrossed(float Seen::*sign, float Seen::*value, const Body& body) const {
    const auto triangles = m_surface.mesh->triangles();
    for (std::uint32_t f = 0; f < triangles.size(); ++f) {
      std::array<bool, 3> negative{};
      for (std::size_t c = 0; c < 3; ++c)
        negative[c] = m_seen[triangles[f][c]].*sign < 0.0f;
      for (std::size_t odd = 0; odd < 3; ++odd) {
        const std::size_t next = (odd + 1) % 3;
        const std::size_t last = (odd + 2) % 3;
        if (negative[odd] != negative[next] && negative[next] == negative[last])
          body(f, std::array{endOn(triangles[f][odd], triangles[f][next], value),
                             endOn(triangles[f][odd], triangles[f][last], value)});
      }
    }
  }

  const model::Surface& m_surface;
  const render::LineRequest& m_request;
  std::vector<Seen> m_seen;
};

using Row = std::tuple<std::uint32_t, float, float, float, float, float, float>;
std::vector<Row> rows(const std::vector<render::Segment>& segments) {
  std::vector<Row> all;
  for (const render::Segment& s : segments)
    all.emplace_back(s.triangle, s.a.x, s.a.y, s.a.z, s.b.x, s.b.y, s.b.z);
  std::sort(all.begin(), all.end());
  return all;
}

/// Returns an egg with bumps of many sizes, on which lines are everywhere.
model::MeshPtr bumpy() {
  const model::MeshPtr ball = test::sphere(20.0f, 6);
  std::vector<glm::vec3> positions(ball->positions().begin(), ball->positions().end());
  for (glm::vec3& p : positions) {
    const glm::vec3 waves = glm::sin(0.55f * p + glm::vec3(0.3f, 1.1f, 2.3f));
    const glm::vec3 ripples = glm::sin(2.1f * p);
    p *= 1.0f + 0.12f * waves.x * waves.y * waves.z + 0.02f * ripples.x * ripples.y +
         0.2f * p.z / 20.0f;
  }
  return std::make_shared<const model::Mesh>(
      std::move(
          model::Mesh::create(positions, {ball->triangles().begin(), ball->triangles().end()}))
          .value());
}

model::Camera seenFrom(const glm::vec3& eye, model::Projection projection) {
  return {.projection = projection, .eye = eye, .target = {1, 2, 3}, .up = {0, 0.1f, 1}};
}

}  // namespace

class PlainScanTest : public QObject {
  Q_OBJECT
 private slots:
  void linesAreThoseOfAPlainScan_data() {
    QTest::addColumn<model::MeshPtr>("mesh");
    QTest::newRow("bumpy") << bumpy();
    QTest::newRow("torus") << test::torus(14, 5, 301, 113);
    QTest::newRow("open") << test::paraboloid(0.1f, -0.08f, 20, 130);
    QTest::newRow("soup") << test::together(*test::sphere(9.0f, 4), *test::torus(14, 5, 60, 40));
  }
  void linesAreThoseOfAPlainScan() {
    QFETCH(model::MeshPtr, mesh);
    const model::SurfacePtr surface = model::prepareSurface(mesh);
    std::size_t contours = 0;
    std::size_t suggestive = 0;
    for (const model::Camera& camera :
         {seenFrom({90, -140, 60}, model::Projection::perspective),
          seenFrom({90, -140, 60}, model::Projection::orthographic),
          seenFrom({-12, 160, -30}, model::Projection::orthographic),
          // So near that the direction to the eye turns within clusters; close to a vertex; inside.
          seenFrom({24, -6, 9}, model::Projection::perspective),
          seenFrom(1.001f * mesh->positions()[17], model::Projection::perspective),
          seenFrom({0.5f, 0.25f, -1}, model::Projection::perspective)})
      for (const bool twoSided : {false, true})
        for (const float gamma : {1.3f, 2.0f}) {
          const render::LineRequest request{
              .thresholds = render::thresholdsAt(Gamma::clamped(gamma)), .twoSided = twoSided};
          render::LineSet lines = render::extractLines(*surface, camera, request);
          const PlainScan plain(*surface, camera, request);
          std::vector<render::Segment> plainContours = plain.contours();
          std::vector<render::Segment> plainSuggestive = plain.suggestive();
          compare(lines, plainContours, plainSuggestive);
          contours += plainContours.size();
          suggestive += plainSuggestive.size();
          const std::vector<model::Plane> planes{
              {.normal = glm::normalize(glm::vec3(1, 2, -1)), .offset = 2.5f}};
          for (std::vector<render::Segment>* all :
               {&lines[render::LineKind::contour], &lines[render::LineKind::suggestive],
                &plainContours, &plainSuggestive})
            render::clip(*all, planes);
          compare(lines, plainContours, plainSuggestive);
        }
    QVERIFY(contours > 1000);
    QVERIFY(suggestive > 300);
  }

  // What a closed surface always hides need not be found.
  void hiddenContoursAreThoseThatAreConcave() {
    const model::SurfacePtr surface = model::prepareSurface(bumpy());
    const model::Camera camera = seenFrom({90, -140, 60}, model::Projection::perspective);
    std::vector<render::Segment> all =
        render::extractLines(*surface, camera, {})[render::LineKind::contour];
    const std::size_t before = all.size();
    std::erase_if(all, [](const render::Segment& s) { return s.concave; });
    QVERIFY(all.size() < before);
    QCOMPARE(rows(render::extractLines(*surface, camera,
                                       {.hiddenContours = false})[render::LineKind::contour]),
             rows(all));
  }

 private:
  static void compare(const render::LineSet& lines, const std::vector<render::Segment>& contours,
                      const std::vector<render::Segment>& suggestive) {
    QCOMPARE(rows(lines[render::LineKind::contour]), rows(contours));
    QCOMPARE(rows(lines[render::LineKind::suggestive]), rows(suggestive));
  }
};

SLINE_TEST(PlainScanTest)
#include "plain_scan_test.moc"
