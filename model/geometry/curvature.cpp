// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/curvature.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "model/base/lanes.h"
#include "model/base/parallel.h"
#include "model/geometry/face_fits.h"
#include "model/geometry/tangent_tensors.h"
#include "model/geometry/tensor_average.h"

namespace sline::model {

namespace {

glm::vec3 meanOf(const glm::vec4& sum) {
  return sum.w > 0.0f ? glm::vec3(sum) / sum.w : glm::vec3(0.0f);
}

/// Turns the vertex's tangent frame within its plane so that the tensor, (uu, uv, vv) there,
/// becomes diagonal, with the larger |κ| first.
void diagonalise(const glm::vec3& t, const glm::vec3& normal, glm::vec3& e1, glm::vec2& k) {
  const float mean = 0.5f * (t.x + t.z);
  const float half = 0.5f * (t.x - t.z);
  const float radius = std::hypot(half, t.y);
  // The larger |κ| is mean ± radius, and e1 is the eigenvector of that sign.
  const float sign = mean < 0.0f ? -1.0f : 1.0f;
  k = {mean + sign * radius, mean - sign * radius};
  // This is half the angle of (half, uv), computed on the side that loses no digits.
  const float x = sign * half;
  const float y = sign * t.y;
  glm::vec2 d =
      x >= 0.0f ? glm::vec2(radius + x, y) : glm::vec2(std::abs(y), std::copysign(radius - x, y));
  const float length = glm::length(d);
  d = length > 0.0f ? d / length : glm::vec2(1.0f, 0.0f);
  const TangentFrame<float> frame = tangentFrame(Vector<float>{normal.x, normal.y, normal.z});
  const Vector<float> along = frame.u * d.x + frame.v * d.y;
  e1 = {along.x, along.y, along.z};
}

/// What the two fits give: sums at vertices, and the weights in them.
struct Fits {
  Principal principal;
  std::vector<glm::vec4> derivatives;
  std::vector<float> weights;
};

Fits fits(const Mesh& mesh, std::span<const glm::vec3> normals, const CurvatureOptions& options) {
  const std::size_t count = mesh.vertexCount();
  std::vector<glm::vec3> tensors(count);
  Fits result;
  result.weights.resize(count);
  {
    const std::vector<glm::vec4> sums = summedTensors(mesh, normals);
    parallelFor(count, 8192, [&](std::size_t v) {
      tensors[v] = meanOf(sums[v]);
      result.weights[v] = sums[v].w;
    });
  }
  if (options.smoothingSteps > 0) {
    const TensorAverage average(mesh, normals);
    for (int step = 0; step < options.smoothingSteps; ++step)
      average.step(tensors);
  }
  Principal& principal = result.principal;
  principal = {.e1 = std::vector<glm::vec3>(count), .k = std::vector<glm::vec2>(count)};
  parallelFor(count, 8192, [&](std::size_t v) {
    diagonalise(tensors[v], normals[v], principal.e1[v], principal.k[v]);
  });
  tensors = {};
  result.derivatives = summedDerivatives(mesh, normals, principal);
  return result;
}

glm::vec4 derivativeAt(std::size_t vertex, const Fits& known) {
  const float weight = known.weights[vertex];
  return weight > 0.0f ? known.derivatives[vertex] / weight : glm::vec4(0.0f);
}

}  // namespace

Curvature curvature(const Mesh& mesh, std::span<const glm::vec3> normals,
                    const CurvatureOptions& options) {
  Fits known = fits(mesh, normals, options);
  parallelFor(mesh.vertexCount(), 8192,
              [&](std::size_t v) { known.derivatives[v] = derivativeAt(v, known); });
  return {std::move(known.principal.e1), std::move(known.principal.k),
          std::move(known.derivatives)};
}

Curvature curvatureAt(std::span<const std::uint32_t> vertices, const Mesh& mesh,
                      std::span<const glm::vec3> normals, const CurvatureOptions& options) {
  const Fits known = fits(mesh, normals, options);
  Curvature result{.e1 = std::vector<glm::vec3>(vertices.size()),
                   .k = std::vector<glm::vec2>(vertices.size()),
                   .derivative = std::vector<glm::vec4>(vertices.size())};
  parallelFor(vertices.size(), 8192, [&](std::size_t i) {
    const std::uint32_t v = vertices[i];
    result.e1[i] = known.principal.e1[v];
    result.k[i] = known.principal.k[v];
    result.derivative[i] = derivativeAt(v, known);
  });
  return result;
}

}  // namespace sline::model
