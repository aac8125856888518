// SPDX-License-Identifier: Apache-2.0
// Compares the fields of METHOD §3 with closed forms and with finite differences over the mesh.
#include "render/lines/ground/view_fields.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

#include "model/geometry/surface.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "tests/support/torus.h"

using namespace sline;

namespace {
const test::Torus torus{10.0, 3.0};

float percentile(std::vector<float> values, std::size_t percent) {
  std::sort(values.begin(), values.end());
  return values[values.size() * percent / 100];
}

model::Camera camera(model::Projection projection, const glm::vec3& direction) {
  return {.projection = projection, .eye = 60.0f * direction, .up = {0.3f, 0.9f, 0.1f}};
}
}  // namespace

class ViewFieldsTest : public QObject {
  Q_OBJECT
 private slots:
  void radialCurvatureOnTorus() {
    const auto surface = model::prepareSurface(test::torus(10, 3, 400, 160));
    const glm::vec3 direction = glm::normalize(glm::vec3(0.3f, -0.6f, 0.5f));
    std::vector<float> value;
    std::vector<float> derivative;
    for (std::size_t i = 0; i < surface->normals.size(); ++i) {
      const auto p = torus.at(glm::dvec3(surface->mesh->positions()[i]));
      const float nv = glm::dot(surface->normals[i], direction);
      if (std::abs(nv) > 0.98f)
        continue;
      const glm::vec2 w =
          render::viewInPrincipalFrame(surface->normals[i], surface->curvature.e1[i], direction);
      const glm::vec2 k = surface->curvature.k[i];
      const glm::dvec3 d(direction);
      value.push_back(std::abs(render::radialCurvature(k, w) - float(torus.radialCurvature(p, d))) *
                      3.0f);
      derivative.push_back(
          std::abs(render::radialCurvatureDerivative(k, surface->curvature.derivative[i], w, nv) -
                   float(torus.radialCurvatureDerivative(p, d))) *
          9.0f);
    }
    QVERIFY(percentile(value, 50) < 0.002f);
    QVERIFY(percentile(value, 95) < 0.01f);
    QVERIFY(percentile(derivative, 50) < 0.01f);
    QVERIFY(percentile(derivative, 95) < 0.05f);
  }

  // k is compared with the gradient of nv over each triangle, as METHOD §3 asks.
  void lightGradientAgreesWithDifferences_data() {
    QTest::addColumn<bool>("perspective");
    QTest::newRow("perspective") << true;
    QTest::newRow("orthographic") << false;
  }
  void lightGradientAgreesWithDifferences() {
    QFETCH(bool, perspective);
    const auto surface = model::prepareSurface(test::torus(10, 3, 400, 160));
    const auto cam =
        camera(perspective ? model::Projection::perspective : model::Projection::orthographic,
               glm::normalize(glm::vec3(0.3f, -0.6f, 0.5f)));
    const model::EyePoint eye = render::eyeOf(cam);
    const auto positions = surface->mesh->positions();
    const auto gradientAt = [&](std::uint32_t v) {
      const float distance = eye.atInfinity ? std::numeric_limits<float>::infinity()
                                            : glm::distance(eye.value, positions[v]);
      return render::lightGradient(surface->normals[v], surface->curvature.e1[v],
                                   surface->curvature.k[v], render::directionTo(eye, positions[v]),
                                   distance);
    };
    const auto brightness = [&](std::uint32_t v) {
      return glm::dot(surface->normals[v], render::directionTo(eye, positions[v]));
    };
    std::vector<float> error;
    for (const auto& [a, b, c] : surface->mesh->triangles()) {
      const glm::vec3 mean = (gradientAt(a) + gradientAt(b) + gradientAt(c)) / 3.0f;
      for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
        const glm::vec3 edge = positions[to] - positions[from];
        const float measured = (brightness(to) - brightness(from)) / glm::length(edge);
        error.push_back(std::abs(measured - glm::dot(mean, edge) / glm::length(edge)) * 3.0f);
      }
    }
    QVERIFY(percentile(error, 50) < 0.005f);
    QVERIFY(percentile(error, 95) < 0.02f);
  }

  void lightGradientPointsToTheEyeOnConvexParts() {
    const glm::vec3 n(0, 0, 1);
    const glm::vec3 v = glm::normalize(glm::vec3(1, 0, 1));
    const float far = std::numeric_limits<float>::infinity();
    QVERIFY(glm::dot(render::lightGradient(n, {1, 0, 0}, {0.2f, 0.2f}, v, far), v) > 0.0f);
    QVERIFY(glm::dot(render::lightGradient(n, {1, 0, 0}, {-0.2f, -0.2f}, v, far), v) < 0.0f);
  }
};

SLINE_TEST(ViewFieldsTest)
#include "view_fields_test.moc"
