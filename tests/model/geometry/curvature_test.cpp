// SPDX-License-Identifier: Apache-2.0
// Tests METHOD §2.5: accuracy of the estimate on surfaces of known curvature.
#include "model/geometry/curvature.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/geometry/normals.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {
constexpr float ringRadius = 10.0f;
constexpr float tubeRadius = 3.0f;
// R's error under jitter grows with |κ1 − κ2|: none on a sphere, 1.25 times a cylinder's here.
constexpr float bendX = 0.08f;
constexpr float bendY = -0.02f;
constexpr float patchSize = 6.0f;

/// Returns the principal curvatures with the larger magnitude first, or NaN if a border is near.
using Known = glm::vec2 (*)(const glm::vec3&);
using Project = glm::vec3 (*)(const glm::vec3&);

glm::vec2 sorted(float a, float b) {
  return std::abs(a) >= std::abs(b) ? glm::vec2(a, b) : glm::vec2(b, a);
}

glm::vec2 onSphere(const glm::vec3&) {
  return {1.0f / 5.0f, 1.0f / 5.0f};
}
glm::vec3 toSphere(const glm::vec3& p) {
  return 5.0f * glm::normalize(p);
}

glm::vec2 onCylinder(const glm::vec3& p) {
  return std::abs(p.z) > 4.0f ? glm::vec2(NAN) : glm::vec2(1.0f / 4.0f, 0.0f);
}
glm::vec3 toCylinder(const glm::vec3& p) {
  const float r = std::hypot(p.x, p.y);
  return {4.0f * p.x / r, 4.0f * p.y / r, p.z};
}

glm::vec2 onTorus(const glm::vec3& p) {
  const float r = std::hypot(p.x, p.y);
  const float cosine = (r - ringRadius) / tubeRadius;
  return sorted(1.0f / tubeRadius, cosine / r);
}
glm::vec3 toTorus(const glm::vec3& p) {
  const float r = std::hypot(p.x, p.y);
  const glm::vec3 ring(ringRadius * p.x / r, ringRadius * p.y / r, 0.0f);
  return ring + tubeRadius * glm::normalize(p - ring);
}

/// Returns them on z = (a·x² + b·y²)/2 with normals to +z: the shape operator dn is minus the
/// graph's bending.
glm::vec2 onSaddle(const glm::vec3& p) {
  if (std::max(std::abs(p.x), std::abs(p.y)) > 0.8f * patchSize)
    return glm::vec2(NAN);
  const double zx = double(bendX) * double(p.x);
  const double zy = double(bendY) * double(p.y);
  const double g = 1.0 + zx * zx + zy * zy;
  const double gauss = double(bendX) * double(bendY) / (g * g);
  const double mean = -((1.0 + zy * zy) * double(bendX) + (1.0 + zx * zx) * double(bendY)) /
                      (2.0 * g * std::sqrt(g));
  const double root = std::sqrt(std::max(0.0, mean * mean - gauss));
  return sorted(float(mean + root), float(mean - root));
}
glm::vec3 toSaddle(const glm::vec3& p) {
  return {p.x, p.y, 0.5f * (bendX * p.x * p.x + bendY * p.y * p.y)};
}

struct Shape {
  const char* name;
  model::MeshPtr (*build)(int fineness);
  Known known;
  Project project;
};

// At fineness 2 each has 20,000 faces or more; fineness 1 has edges twice as long.
const Shape shapes[] = {
    {"sphere", [](int f) { return test::sphere(5.0f, 4 + f - 1); }, onSphere, toSphere},
    {"cylinder", [](int f) { return test::cylinder(4.0f, 12.0f, 100 * f, 60 * f); }, onCylinder,
     toCylinder},
    {"torus", [](int f) { return test::torus(ringRadius, tubeRadius, 150 * f, 50 * f); }, onTorus,
     toTorus},
    {"saddle", [](int f) { return test::paraboloid(bendX, bendY, patchSize, 60 * f); }, onSaddle,
     toSaddle},
};

struct Errors {
  float median;
  float p95;
};

Errors errors(const model::Mesh& mesh, Known known) {
  const auto normals = model::vertexNormals(mesh);
  const model::Curvature c = model::curvature(mesh, normals);
  std::vector<float> all;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    const glm::vec2 truth = known(mesh.positions()[v]);
    if (std::isnan(truth.x))
      continue;
    // Where |κ1| and |κ2| are alike either may come first.
    const auto distance = [&](glm::vec2 k) {
      return std::max(std::abs(k.x - truth.x), std::abs(k.y - truth.y));
    };
    const float error =
        std::min(distance(c.k[v]), distance({c.k[v].y, c.k[v].x})) / std::abs(truth.x);
    all.push_back(error);
  }
  std::sort(all.begin(), all.end());
  return {all[all.size() / 2], all[all.size() * 95 / 100]};
}
}  // namespace

class CurvatureTest : public QObject {
  Q_OBJECT
 private slots:
  void regular_data() {
    QTest::addColumn<int>("shape");
    for (int i = 0; i < 4; ++i)
      QTest::newRow(shapes[i].name) << i;
  }
  void regular() {
    QFETCH(int, shape);
    const Shape& s = shapes[shape];
    const Errors coarse = errors(*s.build(1), s.known);
    const Errors fine = errors(*s.build(2), s.known);
    qInfo("median error %.4f %%, at half the edge length %.4f %%", 100 * double(coarse.median),
          100 * double(fine.median));
    QVERIFY(fine.median <= 0.002f);
    // The error falls at least linearly, unless it is below the noise of single precision, where it
    // cannot fall.
    QVERIFY(fine.median <= 0.5f * coarse.median || fine.median < 1e-4f);
  }

  void jittered_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<float>("jitter");
    QTest::addColumn<float>("medianBound");
    QTest::addColumn<float>("p95Bound");
    for (int i = 0; i < 4; ++i) {
      QTest::addRow("%s 20 %%", shapes[i].name) << i << 0.20f << 0.02f << 0.05f;
      QTest::addRow("%s 35 %%", shapes[i].name) << i << 0.35f << 0.03f << 0.10f;
    }
  }
  void jittered() {
    QFETCH(int, shape);
    QFETCH(float, jitter);
    QFETCH(float, medianBound);
    QFETCH(float, p95Bound);
    const Shape& s = shapes[shape];
    const auto mesh = test::jittered(*s.build(2), jitter, 5, s.project);
    const Errors e = errors(*mesh, s.known);
    qInfo("median %.3f %%, 95th percentile %.3f %%", 100 * double(e.median), 100 * double(e.p95));
    QVERIFY(e.median <= medianBound);
    QVERIFY(e.p95 <= p95Bound);
  }

  // On the torus C(e,e,e) along the meridian is zero and along the ring too; the mixed entry is the
  // change of the ring's curvature along the meridian: d/ds cos v/(R + r·cos v), s = r·v.
  void derivativeOnTorus() {
    const auto mesh = test::torus(ringRadius, tubeRadius, 300, 100);
    const auto normals = model::vertexNormals(*mesh);
    const model::Curvature c = model::curvature(*mesh, normals);
    std::vector<float> error;
    for (std::size_t v = 0; v < mesh->vertexCount(); ++v) {
      const glm::vec3 p = mesh->positions()[v];
      const float ring = std::hypot(p.x, p.y);
      const float sine = p.z / tubeRadius;
      const float expected = -sine * ringRadius / (tubeRadius * ring * ring);
      const glm::vec3 up(-sine * p.x / ring, -sine * p.y / ring, (ring - ringRadius) / tubeRadius);
      const float along = glm::dot(c.e1[v], up) > 0.0f ? 1.0f : -1.0f;
      // e1 runs along the meridian, so C(e1,e2,e2) is the entry.
      error.push_back(std::abs(along * c.derivative[v].z - expected));
      error.push_back(std::abs(c.derivative[v].x));
      error.push_back(std::abs(c.derivative[v].w));
    }
    std::sort(error.begin(), error.end());
    QVERIFY(error[error.size() / 2] < 1e-3f / tubeRadius / tubeRadius);
    QVERIFY(error[error.size() * 95 / 100] < 1e-2f / tubeRadius / tubeRadius);
  }

  void facesWithoutAreaAndLoneVertices() {
    const auto mesh =
        model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {9, 9, 9}, {0, 0, 0}},
                            {{0, 1, 2}, {0, 1, 3}, {0, 5, 1}, {1, 1, 1}});
    const auto normals = model::vertexNormals(mesh.value());
    const model::Curvature c = model::curvature(mesh.value(), normals);
    QCOMPARE(normals[4], glm::vec3(0.0f));
    for (std::size_t v = 0; v < 6; ++v) {
      QVERIFY(std::isfinite(c.k[v].x) && std::isfinite(c.k[v].y));
      QVERIFY(std::isfinite(c.derivative[v].x) && std::isfinite(c.derivative[v].w));
    }
    QCOMPARE(c.k[4], glm::vec2(0.0f));
  }

  void facesTooLargeToMeasure() {
    constexpr float s = 9e7f;
    const auto mesh = model::Mesh::create(
        {{0, 0, 0}, {s, 0, 0}, {-s, 0.3f * s, 0}, {0.2f * s, -0.3f * s, 0.4f * s}},
        {{0, 1, 2}, {0, 3, 1}});
    const model::Curvature c =
        model::curvature(mesh.value(), model::vertexNormals(mesh.value()), {.smoothingSteps = 3});
    for (std::size_t v = 0; v < 4; ++v)
      QVERIFY(std::isfinite(c.k[v].x) && std::isfinite(c.k[v].y) &&
              std::isfinite(c.derivative[v].x) && std::isfinite(c.derivative[v].w));
  }

  void aVertexIsNotItsOwnNeighbour() {
    const auto ball = test::sphere(5.0f, 3);
    std::vector<model::Triangle> triangles(ball->triangles().begin(), ball->triangles().end());
    const std::uint32_t a = triangles[7][0];
    triangles.push_back({a, a, a});
    const auto more = model::Mesh::create({ball->positions().begin(), ball->positions().end()},
                                          std::move(triangles));
    const model::CurvatureOptions smooth{.smoothingSteps = 3};
    const model::Curvature c = model::curvature(*ball, model::vertexNormals(*ball), smooth);
    const model::Curvature d =
        model::curvature(more.value(), model::vertexNormals(more.value()), smooth);
    for (std::size_t v = 0; v < c.k.size(); ++v)
      QCOMPARE(d.k[v], c.k[v]);
  }

  void smoothingKeepsASphere() {
    const auto mesh = test::sphere(5.0f, 5);
    const auto normals = model::vertexNormals(*mesh);
    const model::Curvature c = model::curvature(*mesh, normals, {.smoothingSteps = 4});
    for (const glm::vec2& k : c.k)
      QVERIFY(std::abs(k.x - 0.2f) < 0.004f && std::abs(k.y - 0.2f) < 0.004f);
  }
};

SLINE_TEST(CurvatureTest)
#include "curvature_test.moc"
