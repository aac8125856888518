// SPDX-License-Identifier: Apache-2.0
#include "tests/model/demo/demo_measures.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <sstream>
#include <string>

#include "model/geometry/spatial_order.h"
#include "model/geometry/topology.h"

namespace sline::test {

double volumeOf(const model::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles())
    sum +=
        double(glm::dot(mesh.positions()[a], glm::cross(mesh.positions()[b], mesh.positions()[c])));
  return sum / 6.0;
}

std::vector<double> volumesOfParts(const model::Mesh& mesh) {
  const model::Components parts = model::connectedComponents(mesh);
  std::vector<double> volumes(parts.count, 0.0);
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    const auto& [a, b, c] = mesh.triangles()[t];
    volumes[parts.ofTriangle[t]] +=
        double(
            glm::dot(mesh.positions()[a], glm::cross(mesh.positions()[b], mesh.positions()[c]))) /
        6.0;
  }
  std::sort(volumes.begin(), volumes.end(), std::greater<>());
  return volumes;
}

int handlesOf(const model::Mesh& mesh) {
  // Euler and Poincaré: V − E + F = 2 − 2 g, and E = 3 F / 2.
  return 1 - (int(mesh.vertexCount()) - int(mesh.triangleCount()) / 2) / 2;
}

bool inside(const model::Bvh& bvh, const glm::vec3& p) {
  int crossings = 0;
  model::Ray ray{.origin = p, .direction = {0.577f, 0.211f, 0.789f}};
  while (const auto hit = bvh.nearest(ray)) {
    ++crossings;
    ray.nearest = hit->t * (1.0f + 1e-5f) + 1e-4f;
  }
  return crossings % 2 == 1;
}

double misfitOfBestEllipsoid(const model::Mesh& mesh) {
  // Points spread over an ellipsoid's surface, mapped by the root of their inverse second moments,
  // lie nearly on a sphere: qᵀ M⁻¹ q is the square of the radius there.
  glm::dvec3 mean(0.0);
  for (const glm::vec3& p : mesh.positions())
    mean += glm::dvec3(p) / double(mesh.vertexCount());
  glm::dmat3 moments(0.0);
  for (const glm::vec3& p : mesh.positions()) {
    const glm::dvec3 q = glm::dvec3(p) - mean;
    moments += glm::outerProduct(q, q) / double(mesh.vertexCount());
  }
  const glm::dmat3 inverse = glm::inverse(moments);
  double sum = 0.0;
  double squares = 0.0;
  for (const glm::vec3& p : mesh.positions()) {
    const glm::dvec3 q = glm::dvec3(p) - mean;
    const double radius = std::sqrt(glm::dot(q, inverse * q));
    sum += radius / double(mesh.vertexCount());
    squares += radius * radius / double(mesh.vertexCount());
  }
  return std::sqrt(std::max(squares - sum * sum, 0.0)) / sum;
}

model::Box boundsOfObj(const std::filesystem::path& file, float lowest) {
  model::Box box;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("v "))
      continue;
    std::istringstream numbers(line.substr(2));
    glm::vec3 p;
    numbers >> p.x >> p.y >> p.z;
    if (p.z >= lowest)
      box.add(p);
  }
  return box;
}

Solid::Solid(model::MeshPtr mesh)
    : m_mesh(std::move(mesh)), m_bvh(m_mesh, model::spatialOrder(*m_mesh)) {}

bool Solid::contains(const glm::vec3& p) const {
  return inside(m_bvh, p);
}

double Solid::shareOf(const model::Mesh& other) const {
  const model::Box& box = m_mesh->bounds();
  constexpr std::size_t stride = 5;
  std::size_t inside = 0;
  std::size_t asked = 0;
  for (std::size_t v = 0; v < other.vertexCount(); v += stride, ++asked) {
    const glm::vec3& p = other.positions()[v];
    const bool near = p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y &&
                      p.z > box.low.z && p.z < box.high.z;
    inside += near && contains(p);
  }
  return double(inside) / double(asked);
}

}  // namespace sline::test
