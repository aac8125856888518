// SPDX-License-Identifier: Apache-2.0
// Compares contours and suggestive contours with closed forms, and tests what must not change them.
#include "render/lines/techniques/lines.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>

#include "render/lines/ground/view_fields.h"
#include "render/lines/techniques/line_technique.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "tests/support/torus.h"

using namespace sline;

namespace {
const test::Torus torus{10.0, 3.0};
const glm::vec3 slanted = glm::normalize(glm::vec3(0.2f, -0.92f, 0.34f));

model::Camera orthographic(const glm::vec3& direction) {
  return {.projection = model::Projection::orthographic,
          .eye = 80.0f * direction,
          .target = {0, 0, 0},
          .up = {0, 0.1f, 1}};
}

render::LineRequest request(float gamma) {
  return {.thresholds = render::thresholdsAt(Gamma::clamped(gamma))};
}

glm::vec3 middle(const render::Segment& s) {
  return 0.5f * (s.a + s.b);
}

/// Returns the distance (mm) to the zero line of a function over the torus, to first order.
template <class Function>
double distanceToZero(const Function& f, test::Torus::Point p) {
  const double h = 1e-4;
  const double du = (f({p.u + h, p.v}) - f({p.u - h, p.v})) / (2 * h) /
                    (torus.major + torus.minor * std::cos(p.v));
  const double dv = (f({p.u, p.v + h}) - f({p.u, p.v - h})) / (2 * h) / torus.minor;
  return std::abs(f(p)) / std::max(std::hypot(du, dv), 1e-9);
}

bool nearAny(const std::vector<render::Segment>& segments, const glm::dvec3& p, double reach) {
  return std::any_of(segments.begin(), segments.end(), [&](const render::Segment& s) {
    return glm::distance(glm::dvec3(middle(s)), p) < reach;
  });
}

using Sorted = std::vector<std::array<float, 6>>;
Sorted sorted(const std::vector<render::Segment>& segments, float mirror, float scale) {
  Sorted all;
  for (const render::Segment& s : segments) {
    std::array<float, 3> a{mirror * s.a.x / scale, s.a.y / scale, s.a.z / scale};
    std::array<float, 3> b{mirror * s.b.x / scale, s.b.y / scale, s.b.z / scale};
    if (b < a)
      std::swap(a, b);
    all.push_back({a[0], a[1], a[2], b[0], b[1], b[2]});
  }
  std::sort(all.begin(), all.end());
  return all;
}
}  // namespace

class LinesTest : public QObject {
  Q_OBJECT
 private slots:
  // The contour of a sphere of radius r seen from distance d is a circle of radius
  // r·√(1 − (r/d)²) in the plane at r²/d towards the eye; from infinity, a great circle.
  void sphereContourIsTheExactCircle_data() {
    QTest::addColumn<bool>("perspective");
    QTest::newRow("perspective") << true;
    QTest::newRow("orthographic") << false;
  }
  void sphereContourIsTheExactCircle() {
    QFETCH(bool, perspective);
    const float r = 5.0f;
    const auto surface = model::prepareSurface(test::sphere(r, 5));
    QVERIFY(surface->mesh->triangleCount() >= 20000);
    model::Camera camera = orthographic(slanted);
    const float d = 14.0f;
    if (perspective) {
      camera.projection = model::Projection::perspective;
      camera.eye = d * slanted;
    }
    const float plane = perspective ? r * r / d : 0.0f;
    const float radius = perspective ? r * std::sqrt(1.0f - r * r / d / d) : r;
    const auto lines = render::extractLines(*surface, camera, request(2));
    double length = 0.0;
    for (const render::Segment& s : lines[render::LineKind::contour]) {
      for (const glm::vec3& p : {s.a, s.b}) {
        QVERIFY(std::abs(glm::dot(p, slanted) - plane) < 1e-3f * r);
        QVERIFY(std::abs(glm::length(p - plane * slanted) - radius) < 1e-3f * r);
      }
      length += double(glm::distance(s.a, s.b));
      QVERIFY(!s.concave);
    }
    QVERIFY(std::abs(length / (2.0 * M_PI * double(radius)) - 1.0) < 1e-3);
    QVERIFY(lines[render::LineKind::suggestive].empty());
  }

  void torusContours() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 300, 120));
    const auto lines = render::extractLines(*surface, orthographic(slanted), request(2));
    const auto nv = [](test::Torus::Point p) { return torus.nv(p, glm::dvec3(slanted)); };
    for (const render::Segment& s : lines[render::LineKind::contour]) {
      QVERIFY(distanceToZero(nv, torus.at(glm::dvec3(s.a))) < 0.01);
      // κr < 0 on a contour: the side that the torus itself always hides.
      const double k = torus.radialCurvature(torus.at(glm::dvec3(middle(s))), glm::dvec3(slanted));
      if (std::abs(k) > 0.02)
        QCOMPARE(s.concave, k < 0.0);
    }
    for (int i = 0; i < 400; ++i) {
      // This is tan v where the normal turns away: cos v·(d·radial) + sin v·d.z = 0.
      const double u = 2.0 * M_PI * i / 400;
      const double radial = double(slanted.x) * std::cos(u) + double(slanted.y) * std::sin(u);
      for (const double turn : {0.0, M_PI}) {
        const test::Torus::Point p{u, std::atan2(-radial, double(slanted.z)) + turn};
        QVERIFY(nearAny(lines[render::LineKind::contour], torus.position(p), 0.25));
      }
    }
  }

  void torusSuggestiveContours() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 400, 160));
    const double f2 = double(surface->featureSize) * double(surface->featureSize);
    const glm::dvec3 d(slanted);
    const auto lines = render::extractLines(*surface, orthographic(slanted), request(2));
    const auto kr = [&](test::Torus::Point p) { return torus.radialCurvature(p, d); };
    const auto strength = [&](test::Torus::Point p) {
      return f2 * torus.radialCurvatureDerivative(p, d);
    };
    QVERIFY(lines[render::LineKind::suggestive].size() > 80);
    for (const render::Segment& s : lines[render::LineKind::suggestive]) {
      const auto p = torus.at(glm::dvec3(middle(s)));
      QVERIFY(distanceToZero(kr, p) < 0.03);
      QVERIFY(torus.nv(p, d) > -0.01);
      QVERIFY(torus.nv(p, d) < std::cos(0.05) + 0.01);
      QVERIFY(strength(p) > 0.8);
    }
    int expected = 0;
    for (int i = 0; i < 2000; ++i)
      for (int j = 0; j < 1000; ++j) {
        const double u = 2 * M_PI * i / 2000;
        const double step = 2 * M_PI / 1000;
        const test::Torus::Point a{u, step * j};
        const test::Torus::Point b{u, step * (j + 1)};
        if ((kr(a) < 0) == (kr(b) < 0) || torus.nv(a, d) < 0.03 || torus.nv(a, d) > 0.99 ||
            strength(a) < 1.5)
          continue;
        ++expected;
        QVERIFY(nearAny(lines[render::LineKind::suggestive], torus.position(a), 0.25));
      }
    QVERIFY(expected > 50);
  }

  // Where κr and nv vanish together the two kinds of line meet (METHOD §5).
  void suggestiveContoursReachTheContour() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 300, 120));
    const auto lines = render::extractLines(*surface, orthographic(slanted), request(2));
    int ends = 0;
    for (const render::Segment& s : lines[render::LineKind::suggestive])
      for (const glm::vec3& p : {s.a, s.b}) {
        const auto at = torus.at(glm::dvec3(p));
        if (std::abs(torus.nv(at, glm::dvec3(slanted))) > 1e-3)
          continue;
        ++ends;
        double nearest = 1e9;
        for (const render::Segment& c : lines[render::LineKind::contour])
          nearest =
              std::min({nearest, double(glm::distance(c.a, p)), double(glm::distance(c.b, p))});
        QVERIFY(nearest < double(surface->meanEdge));
      }
    QVERIFY(ends > 0);
  }

  // Segments of one line share their end points to the last bit, so lines can be chained.
  void contoursAreConnected() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 100, 40));
    const auto lines = render::extractLines(*surface, orthographic(slanted), request(2));
    std::map<std::array<float, 3>, int> ends;
    for (const render::Segment& s : lines[render::LineKind::contour])
      for (const glm::vec3& p : {s.a, s.b})
        ++ends[{p.x, p.y, p.z}];
    for (const auto& [point, count] : ends)
      QCOMPARE(count, 2);
  }

  void gammaOnlyAddsSuggestiveContours() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 300, 120));
    std::size_t last = 0;
    for (const float gamma : {1.0f, 1.25f, 1.5f, 1.75f, 2.0f}) {
      const auto lines = render::extractLines(*surface, orthographic(slanted), request(gamma));
      QVERIFY(lines[render::LineKind::suggestive].size() >= last);
      if (gamma == 1.0f)
        QCOMPARE(lines[render::LineKind::suggestive].size(), std::size_t(0));
      last = lines[render::LineKind::suggestive].size();
    }
    QVERIFY(last > 0);
  }

  void mirroredMeshGivesMirroredLines() {
    const auto mesh = test::moved(*test::torus(10, 3, 150, 60), 1.0f, {2, 1, 0});
    const auto a = model::prepareSurface(mesh);
    const auto b = model::prepareSurface(test::mirrored(*mesh));
    const glm::vec3 flipped(-slanted.x, slanted.y, slanted.z);
    const auto one = render::extractLines(*a, orthographic(slanted), request(2));
    const auto other = render::extractLines(*b, orthographic(flipped), request(2));
    compare(sorted(one[render::LineKind::contour], 1, 1),
            sorted(other[render::LineKind::contour], -1, 1), 2e-4f);
    QVERIFY(std::abs(double(one[render::LineKind::suggestive].size()) /
                         double(other[render::LineKind::suggestive].size()) -
                     1.0) < 0.01);
  }

  // Changing millimetres to metres gives the same lines, since every threshold is made
  // dimensionless with F.
  void scaledSceneGivesTheSameLines() {
    const auto mesh = test::torus(10, 3, 150, 60);
    const auto a = model::prepareSurface(mesh);
    const auto b = model::prepareSurface(test::moved(*mesh, 1.0f / 1024.0f, glm::vec3(0)));
    model::Camera camera = orthographic(slanted);
    const auto one = render::extractLines(*a, camera, request(2));
    camera.eye /= 1024.0f;
    const auto other = render::extractLines(*b, camera, request(2));
    compare(sorted(one[render::LineKind::contour], 1, 1024),
            sorted(other[render::LineKind::contour], 1, 1), 1e-7f);
    compare(sorted(one[render::LineKind::suggestive], 1, 1024),
            sorted(other[render::LineKind::suggestive], 1, 1), 1e-5f);
  }

  // The inner side of an open half tube shows the same lines as the outer one of its negative.
  void openSurfacesHaveTwoSides() {
    const auto dish = test::paraboloid(0.15f, 0.1f, 8, 120);
    const auto surface = model::prepareSurface(dish);
    const glm::vec3 below = glm::normalize(glm::vec3(0.4f, 0.3f, -0.6f));
    render::LineRequest both = request(2);
    QVERIFY(render::needsTwoSides(*surface, orthographic(below)));
    both.twoSided = true;
    const auto oneSide = render::extractLines(*surface, orthographic(below), request(2));
    const auto twoSides = render::extractLines(*surface, orthographic(below), both);
    std::vector<model::Triangle> turned(dish->triangles().begin(), dish->triangles().end());
    for (auto& t : turned)
      std::swap(t[1], t[2]);
    const auto inside = std::make_shared<const model::Mesh>(
        std::move(model::Mesh::create({dish->positions().begin(), dish->positions().end()}, turned))
            .value());
    const auto negative =
        render::extractLines(*model::prepareSurface(inside), orthographic(below), both);
    QVERIFY(twoSides[render::LineKind::suggestive].size() >=
            oneSide[render::LineKind::suggestive].size());
    QCOMPARE(twoSides[render::LineKind::contour].size(),
             negative[render::LineKind::contour].size());
    QCOMPARE(twoSides[render::LineKind::suggestive].size(),
             negative[render::LineKind::suggestive].size());
  }

  void cameraInsideAClosedSurfaceSeesItsInnerSide() {
    const auto surface = model::prepareSurface(test::sphere(5, 3));
    model::Camera camera;
    camera.eye = {0.5f, 0, 0};
    QVERIFY(render::needsTwoSides(*surface, camera));
    camera.eye = {9, 0, 0};
    QVERIFY(!render::needsTwoSides(*surface, camera));
  }

 private:
  static void compare(const Sorted& a, const Sorted& b, float tolerance) {
    QCOMPARE(a.size(), b.size());
    // Sorting may exchange near-equal segments; each must have its partner close by.
    for (const auto& s : a) {
      const auto low = std::lower_bound(b.begin(), b.end(), std::array<float, 6>{s[0] - tolerance});
      bool found = false;
      for (auto it = low; it != b.end() && (*it)[0] <= s[0] + tolerance && !found; ++it)
        found = std::equal(s.begin(), s.end(), it->begin(),
                           [&](float x, float y) { return std::abs(x - y) <= tolerance; });
      QVERIFY(found);
    }
  }
};

SLINE_TEST(LinesTest)
#include "lines_test.moc"
