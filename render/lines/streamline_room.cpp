// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamline_room.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

namespace sline::render {

namespace {

float distanceToPiece(const glm::vec3& p, const TracedPoint& a, const TracedPoint& b) {
  const glm::vec3 from(a.place);
  const glm::vec3 along = glm::vec3(b.place) - from;
  const float length2 = glm::dot(along, along);
  const float t =
      length2 > 0.0f ? std::clamp(glm::dot(p - from, along) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, from + t * along);
}

}  // namespace

StreamlineRoom::StreamlineRoom(const model::Mesh& mesh, const model::FaceNeighbours& neighbours)
    : m_neighbours(neighbours),
      m_middles(mesh.triangleCount()),
      m_room(mesh.triangleCount(), std::numeric_limits<float>::infinity()) {
  const auto p = mesh.positions();
  const auto triangles = mesh.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i)
    m_middles[i] = (p[triangles[i][0]] + p[triangles[i][1]] + p[triangles[i][2]]) / 3.0f;
}

void StreamlineRoom::take(const Step& step, std::span<const TracedPoint> line, float reach) {
  // The nearest piece is this one or one beside it, as steps are as small as triangles.
  const std::size_t last = line.size() - 2;
  const std::size_t low = step.piece > 0 ? step.piece - 1 : 0;
  const std::size_t high = std::min<std::size_t>(step.piece + 1, last);
  float nearest = std::numeric_limits<float>::infinity();
  Step found = step;
  for (std::size_t i = low; i <= high; ++i)
    if (const float d = distanceToPiece(m_middles[step.triangle], line[i], line[i + 1]);
        d < nearest) {
      nearest = d;
      found.piece = std::uint32_t(i);
    }
  if (nearest >= std::min(m_room[step.triangle], reach))
    return;
  m_room[step.triangle] = nearest;
  m_steps.push_back(found);
}

void StreamlineRoom::add(std::span<const TracedPoint> line, float reach) {
  m_steps.clear();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    take({line[i].triangle, std::uint32_t(i)}, line, reach);
    take({line[i + 1].triangle, std::uint32_t(i)}, line, reach);
  }
  for (std::size_t next = 0; next < m_steps.size(); ++next) {
    const Step step = m_steps[next];
    for (int side = 0; side < 3; ++side)
      if (const std::uint32_t beside = m_neighbours.across(step.triangle, side);
          beside != model::FaceNeighbours::none)
        take({beside, step.piece}, line, reach);
  }
}

}  // namespace sline::render
