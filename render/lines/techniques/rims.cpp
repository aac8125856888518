// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/rims.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "model/geometry/face_neighbours.h"

namespace sline::render {

namespace {

struct Rims : PreparedLines {
  std::vector<Segment> segments;

  std::size_t count() const override { return segments.size(); }
  std::size_t bytes() const override { return segments.size() * sizeof(Segment); }
};

/// An edge that no other triangle shares, from `a` to `b` counter-clockwise around its own.
struct OpenEdge {
  std::uint32_t a, b;
  std::uint32_t triangle;
  bool alone = true;
};

std::vector<OpenEdge> openEdges(const model::Mesh& mesh) {
  const model::FaceNeighbours neighbours(mesh);
  std::vector<OpenEdge> edges;
  for (std::uint32_t f = 0; f < mesh.triangleCount(); ++f)
    for (int corner = 0; corner < 3; ++corner)
      if (neighbours.across(f, corner) == model::FaceNeighbours::none) {
        const model::Triangle& t = mesh.triangles()[f];
        edges.push_back({t[std::size_t(corner + 1) % 3], t[std::size_t(corner + 2) % 3], f, true});
      }
  return edges;
}

/// Finds edges at the same place, which have a triangle on either side, or more: the surface only
/// seems to end there.
void findSeams(const model::Mesh& mesh, std::vector<OpenEdge>& edges) {
  using Place = std::tuple<float, float, float>;
  const auto placeOf = [&mesh](std::uint32_t vertex) {
    const glm::vec3& p = mesh.positions()[vertex];
    return Place{p.x, p.y, p.z};
  };
  const auto ends = [&](const OpenEdge& edge) {
    return std::minmax({placeOf(edge.a), placeOf(edge.b)});
  };
  std::vector<std::pair<std::pair<Place, Place>, std::size_t>> sorted;
  sorted.reserve(edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
    sorted.emplace_back(ends(edges[i]), i);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (sorted[i].first == sorted[i - 1].first)
      edges[sorted[i].second].alone = edges[sorted[i - 1].second].alone = false;
}

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : glm::vec3(0.0f);
}

}  // namespace

std::unique_ptr<const PreparedLines> prepareRims(const model::Surface& surface) {
  auto rims = std::make_unique<Rims>();
  if (surface.closed)
    return rims;
  const model::Mesh& mesh = *surface.mesh;
  std::vector<OpenEdge> edges = openEdges(mesh);
  findSeams(mesh, edges);
  std::erase_if(edges, [](const OpenEdge& edge) { return !edge.alone; });
  // Where the surface would go on, in its own plane; at a vertex between what its two edges say.
  std::map<std::uint32_t, glm::vec3> onwards;
  for (const OpenEdge& edge : edges) {
    const auto p = mesh.positions();
    const model::Triangle& t = mesh.triangles()[edge.triangle];
    const glm::vec3 normal = unit(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
    const glm::vec3 way = glm::cross(unit(p[edge.b] - p[edge.a]), normal);
    for (const std::uint32_t vertex : {edge.a, edge.b})
      onwards.try_emplace(vertex, 0.0f).first->second += way;
  }
  rims->segments.reserve(edges.size());
  for (const OpenEdge& edge : edges)
    rims->segments.push_back({.a = mesh.positions()[edge.a],
                              .b = mesh.positions()[edge.b],
                              .normalA = unit(onwards[edge.a]),
                              .normalB = unit(onwards[edge.b]),
                              .triangle = edge.triangle});
  return rims;
}

void findRims(const LineSearch& search, std::vector<Segment>& segments) {
  const auto& rims = static_cast<const Rims&>(*search.prepared);
  segments.insert(segments.end(), rims.segments.begin(), rims.segments.end());
}

}  // namespace sline::render
