// SPDX-License-Identifier: Apache-2.0
#include "render/lines/coarse_depth.h"

#include <algorithm>

#include "render/lines/view_fields.h"

namespace sline::render {

namespace {
constexpr float finestCell = 6.0f;  // λ
constexpr float mostCells = 256.0f;
// The share of F by which an obstacle must lie in front of what it hides.
constexpr float clearly = 0.05f;
// Places farther than this from the middle of the picture are ignored, λ.
constexpr float farthest = 4000.0f;
}  // namespace

CoarseDepth::CoarseDepth(const model::Surface& surface, const model::Camera& camera)
    : m_scale(camera), m_slack(clearly * surface.featureSize) {
  const ViewScale::Point middle = m_scale.project(surface.boundingSphere.centre);
  const float radius =
      std::clamp(surface.boundingSphere.radius * middle.perMm * 1.2f, 1.0f, farthest);
  m_side =
      std::max({finestCell, 1.5f * surface.meanEdge * middle.perMm, 2.0f * radius / mostCells});
  m_low = glm::clamp(middle.at, -farthest, farthest) - radius;
  m_columns = m_rows = int(2.0f * radius / m_side) + 1;
  m_nearest.assign(std::size_t(m_columns) * std::size_t(m_rows), nothing);
  const model::EyePoint eye = eyeOf(camera);
  const auto positions = surface.mesh->positions();
  for (const model::Cluster& cluster : surface.clusters.items) {
    if (model::facing(cluster, eye) == model::Facing::back)
      continue;
    for (std::uint32_t i = cluster.firstVertex; i < cluster.firstVertex + cluster.vertexCount;
         ++i) {
      const ViewScale::Point seen = m_scale.project(positions[surface.clusters.vertices[i]]);
      const std::ptrdiff_t c = seen.perMm > 0.0f ? cell(seen.at) : -1;
      if (c >= 0)
        m_nearest[std::size_t(c)] = std::min(m_nearest[std::size_t(c)], seen.distanceMm);
    }
  }
}

std::ptrdiff_t CoarseDepth::cell(const glm::vec2& at) const {
  const glm::vec2 c = (at - m_low) / m_side;
  if (!(c.x >= 0.0f && c.y >= 0.0f && c.x < float(m_columns) && c.y < float(m_rows)))
    return -1;
  return std::ptrdiff_t(c.y) * m_columns + std::ptrdiff_t(c.x);
}

float CoarseDepth::nearest(const glm::vec2& at) const {
  const std::ptrdiff_t c = cell(at);
  return c < 0 ? nothing : m_nearest[std::size_t(c)];
}

bool CoarseDepth::sees(const glm::vec3& p) const {
  const ViewScale::Point seen = m_scale.project(p);
  return seen.perMm > 0.0f && seen.distanceMm <= nearest(seen.at) + m_slack;
}

bool CoarseDepth::surrounds(const glm::vec3& p, const glm::vec3& normal) const {
  const ViewScale::Point seen = m_scale.project(p);
  const glm::vec2 outwards = m_scale.across(normal);
  const float length = glm::length(outwards);
  return seen.perMm > 0.0f && length > 0.0f &&
         nearest(seen.at + 2.0f * m_side / length * outwards) < nothing;
}

}  // namespace sline::render
