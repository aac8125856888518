// SPDX-License-Identifier: Apache-2.0
// Compares the techniques that suggestive contours are compared with with surfaces whose lines are
// known in closed form.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "render/lines/ground/headlight.h"
#include "render/lines/techniques/apparent_ridges.h"
#include "render/lines/techniques/demarcating_curves.h"
#include "render/lines/techniques/line_technique.h"
#include "render/lines/techniques/lines.h"
#include "render/lines/techniques/ridges.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

constexpr double ring = 10.0;
constexpr double tube = 4.0;

const std::array compared{LineKind::apparentRidge,
                          LineKind::ridge,
                          LineKind::valley,
                          LineKind::photic,
                          LineKind::laplacian,
                          LineKind::demarcating,
                          LineKind::suggestiveHighlight,
                          LineKind::principalHighlight};

model::Camera along(const glm::vec3& direction) {
  return {.projection = model::Projection::orthographic,
          .eye = 300.0f * glm::normalize(direction),
          .target = {0, 0, 0},
          .up = {0.01f, 0.1f, 1}};
}

glm::vec3 middle(const Segment& s) {
  return 0.5f * (s.a + s.b);
}

/// Returns a sphere stretched along the axes.
model::MeshPtr ellipsoid(const glm::vec3& axes, int levels) {
  const model::MeshPtr sphere = test::sphere(1.0f, levels);
  std::vector<glm::vec3> positions(sphere->positions().begin(), sphere->positions().end());
  for (glm::vec3& p : positions)
    p *= axes;
  const auto triangles = sphere->triangles();
  return std::make_shared<const model::Mesh>(
      *model::Mesh::create(std::move(positions), {triangles.begin(), triangles.end()}));
}

/// Returns the lines above the usual thresholds, or above a quarter of them.
std::vector<Segment> linesOf(const model::MeshPtr& mesh, LineKind kind, const model::Camera& camera,
                             bool all) {
  const model::SurfacePtr surface = model::prepareSurface(mesh);
  LineRequest request{.kinds = {kind}};
  if (all)
    request.thresholds.set(kind, 0, 0.25f * techniqueOf(kind).thresholds[0].usual);
  return extractLines(*surface, camera, request)[kind];
}

/// The angle around the tube from the outer equator, of a point of the torus around z.
double tubeAngle(const glm::vec3& p) {
  return std::atan2(double(p.z), std::hypot(double(p.x), double(p.y)) - ring);
}

struct Place {
  glm::dvec3 p, n, e1, e2;
};

/// A point of the torus with its normal and principal directions along the tube and the ring.
Place torusAt(double u, double v) {
  const glm::dvec3 out(std::cos(u), std::sin(u), 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dvec3 n = std::cos(v) * out + std::sin(v) * up;
  const glm::dvec3 e1 = -std::sin(v) * out + std::cos(v) * up;
  return {ring * out + tube * n, n, e1, glm::cross(n, e1)};
}

}  // namespace

class ComparisonLinesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() { ring_ = test::torus(float(ring), float(tube), 200, 100); }

  /// f's gradient and Hessian against finite differences along curves over a torus, near the eye
  /// and in a parallel projection: f'' = Hess f(γ',γ') + ⟨∇f, γ''⟩.
  void headlightDerivativesAreExact() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int k = 0; k < 200; ++k) {
      const double u = 3.0 * any(random);
      const double v = 3.0 * any(random);
      const double du = any(random) / ring;
      const double dv = any(random) / tube;
      const bool parallel = k % 2 == 0;
      const glm::dvec3 eye = 40.0 * glm::normalize(glm::dvec3(any(random), any(random), 1.2));
      const auto brightness = [&](double t) {
        const Place at = torusAt(u + t * du, v + t * dv);
        return glm::dot(at.n, glm::normalize(parallel ? eye : eye - at.p));
      };
      const auto point = [&](double t) { return torusAt(u + t * du, v + t * dv).p; };
      constexpr double h = 1e-3;
      const double first = (brightness(h) - brightness(-h)) / (2.0 * h);
      const double second = (brightness(h) - 2.0 * brightness(0.0) + brightness(-h)) / (h * h);
      const glm::dvec3 speed = (point(h) - point(-h)) / (2.0 * h);
      const glm::dvec3 bend = (point(h) - 2.0 * point(0.0) + point(-h)) / (h * h);
      const Place at = torusAt(u, v);
      const double rho = ring + tube * std::cos(v);
      const glm::dvec3 view = glm::normalize(parallel ? eye : eye - at.p);
      const auto framed = [&at](const glm::dvec3& x) {
        return glm::vec2(glm::dot(x, at.e1), glm::dot(x, at.e2));
      };
      const Headlight f = headlight(
          glm::vec2(1.0 / tube, std::cos(v) / rho),
          glm::vec4(0.0, 0.0, -std::sin(v) * ring / (rho * rho * tube), 0.0), framed(view),
          float(glm::dot(at.n, view)),
          parallel ? std::numeric_limits<float>::infinity() : float(glm::distance(eye, at.p)));
      const glm::vec2 x = framed(speed);
      QVERIFY2(std::abs(glm::dot(f.gradient, x) - first) < 2e-5, "gradient");
      const double hessian = double(f.along(x)) + double(glm::dot(f.gradient, framed(bend)));
      QVERIFY2(std::abs(hessian - second) < 3e-5,
               qPrintable(QString("%1 instead of %2").arg(hessian).arg(second)));
    }
  }

  /// Nothing lies inside the contour of a sphere or a cylinder.
  void evenSurfacesAreEmpty() {
    const model::MeshPtr sphere = test::sphere(20.0f, 5);
    const model::MeshPtr cylinder = test::cylinder(8.0f, 60.0f, 96, 40);
    for (const LineKind kind : compared)
      for (const model::MeshPtr& mesh : {sphere, cylinder}) {
        const model::Camera camera = along({0.3f, -0.9f, 0.2f});
        const glm::vec3 view = glm::normalize(camera.eye);
        for (const Segment& s : linesOf(mesh, kind, camera, false)) {
          const bool rim = mesh == cylinder && std::abs(middle(s).z) > 25.0f;
          QVERIFY2(rim || glm::dot(s.normalA, view) < 0.2f, techniqueOf(kind).id);
        }
      }
  }

  /// Seen along its axis, Δf is zero on a torus where cos v = −R/(2r), and nowhere else.
  void laplacianLinesOfATorus() {
    // R < 2r is needed.
    constexpr double wide = 6.0;
    const double expected = std::acos(-ring / (2.0 * wide));
    const auto mesh = test::torus(float(ring), float(wide), 240, 160);
    const auto segments = linesOf(mesh, LineKind::laplacian, along({0, 0, 1}), true);
    QVERIFY(segments.size() > 200);
    for (const Segment& s : segments) {
      const double v = tubeAngle(middle(s));
      // Where the surface turns away is the contour, and the top, where f is greatest, is even.
      if (std::sin(v) < 0.1)
        continue;
      QVERIFY2(std::abs(v - expected) < 0.02, qPrintable(QString::number(v)));
    }
  }

  void photicExtremaOfATorusFromAbove() {
    // Seen along the axis f = sin v and |∇f| = |cos v|/r is greatest at the contours alone.
    for (const Segment& s : linesOf(ring_, LineKind::photic, along({0, 0, 1}), false))
      QVERIFY2(std::abs(std::sin(tubeAngle(middle(s)))) < 0.1, "inside the contour");
  }

  /// On a torus they are circles at cos v = −R/(3r).
  void demarcatingCurvesOfATorus() {
    const double expected = std::acos(-ring / (3.0 * tube));
    for (const float side : {1.0f, -1.0f}) {
      const auto segments = linesOf(ring_, LineKind::demarcating, along({0.1f, 0.2f, side}), true);
      QVERIFY2(segments.size() > 150, qPrintable(QString::number(segments.size())));
      for (const Segment& s : segments) {
        const double v = std::abs(tubeAngle(middle(s)));
        QVERIFY2(std::abs(v - expected) < 0.02, qPrintable(QString::number(v)));
      }
    }
  }

  void steepestCurvatureIsTheGreatest() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int k = 0; k < 500; ++k) {
      const glm::vec4 c(any(random), any(random), any(random), any(random));
      const auto value = [&c](const glm::dvec2& g) {
        return double(c.x) * g.x * g.x * g.x + 3.0 * double(c.y) * g.x * g.x * g.y +
               3.0 * double(c.z) * g.x * g.y * g.y + double(c.w) * g.y * g.y * g.y;
      };
      double greatest = 0.0;
      for (int i = 0; i < 3600; ++i) {
        const double angle = double(i) * 0.1 * 3.14159265358979 / 180.0;
        greatest = std::max(greatest, value({std::cos(angle), std::sin(angle)}));
      }
      const glm::dvec2 g(steepestCurvature(c));
      QVERIFY(std::abs(glm::length(g) - 1.0) < 1e-6);
      QVERIFY2(value(g) > greatest - 1e-5, qPrintable(QString::number(value(g) - greatest)));
    }
  }

  /// An oblate spheroid is sharpest along its equator.
  void ridgeOfASpheroid() {
    const auto segments =
        linesOf(ellipsoid({20, 20, 12}, 5), LineKind::ridge, along({0.2f, -1.0f, 0.3f}), false);
    QVERIFY2(segments.size() > 60, qPrintable(QString::number(segments.size())));
    float length = 0.0f;
    for (const Segment& s : segments) {
      QVERIFY2(std::abs(middle(s).z) < 0.1f, qPrintable(QString::number(middle(s).z)));
      length += glm::distance(s.a, s.b);
    }
    QVERIFY2(std::abs(length - 3.14159f * 20.0f) < 1.0f, qPrintable(QString::number(length)));
    QVERIFY(
        linesOf(ellipsoid({20, 20, 12}, 5), LineKind::valley, along({0, -1, 0}), false).empty());
  }

  /// Those of an ellipsoid of three different axes lie in its planes of symmetry.
  void ridgesOfAnEllipsoid() {
    const auto segments =
        linesOf(ellipsoid({24, 16, 10}, 6), LineKind::ridge, along({0.5f, -0.6f, 0.7f}), false);
    QVERIFY(segments.size() > 60);
    for (const Segment& s : segments) {
      const glm::vec3 p = glm::abs(middle(s));
      QVERIFY2(std::min({p.x, p.y, p.z}) < 0.6f,
               qPrintable(QString("%1 %2 %3").arg(p.x).arg(p.y).arg(p.z)));
    }
  }

  /// Each curvature of a torus is the same all along its own line, so it has neither.
  void noRidgesOnATorus() {
    for (const LineKind kind : {LineKind::ridge, LineKind::valley})
      QVERIFY2(linesOf(ring_, kind, along({0.3f, -0.5f, 0.8f}), false).empty(),
               techniqueOf(kind).id);
  }

  /// q1 is κ1 where one looks straight at the surface, and 1/(r cos θ) on a sphere; its direction
  /// is the one that looks shortest.
  void apparentCurvatureOfKnownPlaces() {
    const ApparentCurvature plain = apparentCurvature({0.5f, -0.2f}, {0.0f, 0.0f}, 1.0f);
    QVERIFY(std::abs(plain.q1 - 0.5f) < 1e-6f && std::abs(std::abs(plain.along.x) - 1.0f) < 1e-6f);
    const float cosine = 0.4f;
    const float sine = std::sqrt(1.0f - cosine * cosine);
    const glm::vec2 w = sine * glm::vec2(0.6f, 0.8f);
    const ApparentCurvature ball = apparentCurvature({0.1f, 0.1f}, w, cosine);
    QVERIFY(std::abs(ball.q1 - 0.1f / cosine) < 1e-5f);
    QVERIFY(std::abs(std::abs(glm::dot(ball.along, glm::vec2(0.6f, 0.8f))) - 1.0f / cosine) <
            1e-4f);
    // Against the greatest turning of the normal per way in the picture.
    std::mt19937 random(5);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int k = 0; k < 100; ++k) {
      const glm::vec2 curvature(any(random), 0.3f * any(random));
      const glm::vec2 u = glm::normalize(glm::vec2(any(random), any(random)));
      const float nv = 0.1f + 0.85f * std::abs(any(random));
      float greatest = 0.0f;
      for (int i = 0; i < 720; ++i) {
        const float angle = float(i) * 3.14159265f / 720.0f;
        const glm::vec2 x(std::cos(angle), std::sin(angle));
        const float across = glm::dot(x, u);
        const float seen = std::sqrt(1.0f - across * across + across * across * nv * nv);
        greatest = std::max(greatest, glm::length(curvature * x) / seen);
      }
      const ApparentCurvature found =
          apparentCurvature(curvature, std::sqrt(1.0f - nv * nv) * u, nv);
      QVERIFY2(std::abs(found.q1 - greatest) < 2e-3f * greatest + 1e-4f, "q1");
    }
  }

  /// The rim of a lens that is seen from above bends most for the eye, most of all in front.
  void apparentRidgeOfASpheroid() {
    const auto segments = linesOf(ellipsoid({20, 20, 6}, 6), LineKind::apparentRidge,
                                  along({0.0f, -1.0f, 0.9f}), false);
    float before = 0.0f;
    for (const Segment& s : segments) {
      const glm::vec3 p = middle(s);
      QVERIFY2(std::abs(p.z) < 3.0f && std::hypot(p.x, p.y) > 17.0f,
               qPrintable(QString("%1 %2 %3").arg(p.x).arg(p.y).arg(p.z)));
      before += p.y < -14.0f ? glm::distance(s.a, s.b) : 0.0f;
    }
    // A quarter of the rim lies that far in front.
    QVERIFY2(before > 25.0f && before < 45.0f, qPrintable(QString::number(before)));
  }

  void thresholdsThinLines() {
    const model::SurfacePtr surface = model::prepareSurface(test::askew(*ring_));
    const model::Camera camera = along({0.4f, -0.8f, 0.5f});
    for (const LineKind kind : compared) {
      LineRequest request{.kinds = {kind}};
      std::size_t before = std::numeric_limits<std::size_t>::max();
      for (const float factor : {0.1f, 1.0f, 10.0f, 1e4f}) {
        request.thresholds.set(kind, 0, factor * techniqueOf(kind).thresholds[0].usual);
        const std::size_t count = extractLines(*surface, camera, request)[kind].size();
        QVERIFY2(count <= before, techniqueOf(kind).id);
        before = count;
      }
      QVERIFY2(before == 0, techniqueOf(kind).id);
    }
  }

 private:
  model::MeshPtr ring_;
};

SLINE_TEST(ComparisonLinesTest)
#include "comparison_lines_test.moc"
