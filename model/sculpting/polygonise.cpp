// SPDX-License-Identifier: Apache-2.0
#include "model/sculpting/polygonise.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "model/base/parallel.h"
#include "model/geometry/topology.h"
#include "model/isosurface/zero_surface.h"
#include "model/sculpting/field_grid.h"
#include "model/sculpting/remesh.h"

namespace sline::model {

namespace {
constexpr int roundsOfRemeshing = 5;
constexpr int relaxations = 4;
/// Edges outside these limits, as shares of the requested edge, are mended.
constexpr float shortest = 0.7f;
constexpr float longest = 1.45f;

Facets flyingEdges(const Field& field, const Box& box, float cell) {
  const FieldGrid grid(field, box, cell);
  ZeroSurface raw = zeroSurface(
      {.size = grid.size(), .origin = box.low, .step = glm::dvec3(cell), .values = grid.values()});
  return {std::move(raw.positions), std::move(raw.triangles)};
}

/// Returns the gradient from differences over the corners of a tetrahedron.
glm::vec3 gradient(const Field& field, const glm::vec3& p, float h) {
  glm::vec3 sum(0.0f);
  for (const glm::vec3 d :
       {glm::vec3(1, 1, 1), glm::vec3(1, -1, -1), glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1)})
    sum += field(p + h * d) * d;
  return sum / (4.0f * h);
}

/// Moves the point onto field = 0 by Newton steps along the gradient at the start, which is
/// accurate enough; none is longer than half an edge, whatever the gradient at a crease may be.
glm::vec3 projected(const Field& field, glm::vec3 p, float edge) {
  const glm::vec3 g = gradient(field, p, 0.05f * edge);
  const float slope = glm::length(g);
  if (slope < 0.1f)
    return p;
  for (int step = 0; step < 3; ++step)
    p -= std::clamp(field(p) / slope, -0.5f * edge, 0.5f * edge) * g / slope;
  return p;
}

/// Holds the area-weighted mean of the centroids of a vertex's triangles, and their mean normal.
struct Umbrella {
  glm::vec3 centroid;
  glm::vec3 normal;  ///< unit vector, or zero
};

Umbrella umbrella(const Facets& raw, std::span<const std::uint32_t> faces, float edge) {
  glm::vec3 sum(0.0f);
  glm::vec3 normal(0.0f);
  float weights = 0.0f;
  for (const std::uint32_t f : faces) {
    const auto& [a, b, c] = raw.triangles[f];
    const glm::vec3 pa = raw.positions[a];
    const glm::vec3 pb = raw.positions[b];
    const glm::vec3 pc = raw.positions[c];
    const glm::vec3 cross = glm::cross(pb - pa, pc - pa);
    const float area = glm::length(cross) + 1e-6f * edge * edge;
    normal += cross;
    sum += area * (pa + pb + pc) / 3.0f;
    weights += area;
  }
  const float length = glm::length(normal);
  return {sum / weights, length > 0.0f ? normal / length : glm::vec3(0.0f)};
}

/// Moves each vertex towards the centroid of its triangles within the surface, then, if `back`,
/// back onto the surface along the mesh's normal (outward). That takes the field for a distance,
/// which it is near the surface; Newton's steps come last.
void relax(const Field& field, Facets& raw, const VertexFaces& faces, float edge, bool back) {
  std::vector<glm::vec3> moved(raw.positions.size());
  parallelFor(moved.size(), 256, [&](std::size_t v) {
    const glm::vec3 p = raw.positions[v];
    if (faces[v].empty()) {
      moved[v] = p;
      return;
    }
    const Umbrella u = umbrella(raw, faces[v], edge);
    const glm::vec3 step = u.centroid - p;
    glm::vec3 q = p + step - glm::dot(step, u.normal) * u.normal;
    if (back)
      q -= std::clamp(field(q), -0.3f * edge, 0.3f * edge) * u.normal;
    moved[v] = q;
  });
  raw.positions = std::move(moved);
}

float signedVolume(const Facets& raw) {
  double volume = 0.0;
  for (const auto& [a, b, c] : raw.triangles)
    volume += double(glm::dot(raw.positions[a], glm::cross(raw.positions[b], raw.positions[c])));
  return float(volume / 6.0);
}

Facets outward(Facets raw) {
  if (signedVolume(raw) < 0.0f)
    for (Triangle& t : raw.triangles)
      std::swap(t[1], t[2]);
  return raw;
}

MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  auto mesh = Mesh::create(std::move(positions), std::move(triangles));
  return std::make_shared<const Mesh>(std::move(mesh).value());
}

void relax(const Field& field, Facets& raw, float edge, int times) {
  const VertexFaces faces(*meshOf(raw.positions, raw.triangles));
  for (int i = 0; i < times; ++i)
    relax(field, raw, faces, edge, i % 2 == 1);
}
}  // namespace

MeshPtr polygonise(const Field& field, const Box& box, float edge) {
  // A lattice cell holds about three triangles per square of surface, so their edges are shorter
  // than the cell.
  Facets raw = outward(flyingEdges(field, box, 1.15f * edge));
  for (int round = 0; round < roundsOfRemeshing; ++round) {
    relax(field, raw, edge, 2);
    drawTogether(raw, shortest * edge, longest * edge);
    for (int turn = 0; turn < 3; ++turn)
      turnEdges(raw);
  }
  relax(field, raw, edge, relaxations);
  return fitted(std::move(raw), field, edge);
}

MeshPtr fitted(Facets pattern, const Field& field, float edge) {
  pattern = outward(std::move(pattern));
  std::vector<glm::vec3>& positions = pattern.positions;
  parallelFor(positions.size(), 256,
              [&](std::size_t v) { positions[v] = projected(field, positions[v], edge); });
  return meshOf(std::move(positions), std::move(pattern.triangles));
}

}  // namespace sline::model
