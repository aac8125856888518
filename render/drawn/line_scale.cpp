// SPDX-License-Identifier: Apache-2.0
#include "render/drawn/line_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/parallel.h"
#include "model/fairing/faired.h"
#include "model/geometry/edge_length.h"

namespace sline::render {

namespace {

constexpr float usualScale = 4.0f;  // λ
// Larger deviations would take a structure's own form away, as a share of F.
constexpr float largestShare = 0.125f;
// Scales are twice as large from one level to the next; level 0, the surface itself, counts as a
// deviation of this many mean edges.
constexpr float levelZero = 1.0f;
// The part of a level in which its lines give way to the next one's.
constexpr float fadeFrom = 0.35f;
constexpr float fadeTo = 0.65f;
// Levels that are kept.
constexpr std::size_t mostLevels = 3;
// Beyond the deviation that is this share of F, the least derivative is raised in proportion.
constexpr float trustedShare = 0.03f;

}  // namespace

float scaleDeviation(const model::Surface& surface, const PictureView& view, float lineScale,
                     float known) {
  const float mm = view.millimetresPerPixel(surface.boundingSphere.centre) * view.outputUnit();
  const float wanted = std::min(lineScale * usualScale * mm, largestShare * surface.featureSize);
  return std::sqrt(std::max(wanted * wanted - known * known, 0.0f));
}

void LineScales::smooth(model::FinerMesh finer) {
  m_finer = std::move(finer);
  m_finerEdge = model::meanEdgeLength(m_finer.mesh->positions(), m_finer.mesh->triangles());
}

float LineScales::deviationOf(const model::Surface& surface, int level) const {
  return levelZero * (m_finer.mesh ? m_finerEdge : surface.meanEdge) * std::exp2(float(level));
}

float LineScales::thresholdOf(const model::Surface& surface, int level) const {
  return std::max(1.0f, deviationOf(surface, level) / (trustedShare * surface.featureSize));
}

std::vector<ScaledShape> LineScales::at(const model::SurfacePtr& surface, float deviation) {
  const float at = deviation > 0.0f && surface->meanEdge > 0.0f
                       ? std::log2(deviation / deviationOf(*surface, 0))
                       : 0.0f;
  if (!(at > fadeFrom))
    return {{surface}};
  const int low = int(std::floor(at));
  const float t = std::clamp((at - float(low) - fadeFrom) / (fadeTo - fadeFrom), 0.0f, 1.0f);
  std::vector<std::pair<int, float>> wanted{{low, 1.0f - t}, {low + 1, t}};
  std::erase_if(wanted, [](const auto& one) { return !(one.second > 0.0f); });
  if (m_hurried && !knows(wanted)) {
    m_lacks = true;
    return {nearest(surface, at)};
  }
  std::vector<ScaledShape> shapes;
  shapes.reserve(wanted.size());
  for (const auto& [which, share] : wanted)
    shapes.push_back({level(surface, which), share, thresholdOf(*surface, which)});
  return shapes;
}

void LineScales::hurry(bool hurried) {
  m_hurried = hurried;
  m_lacks = false;
}

bool LineScales::knows(const std::vector<std::pair<int, float>>& wanted) const {
  const std::lock_guard lock(m_mutex);
  return std::all_of(wanted.begin(), wanted.end(), [this](const auto& one) {
    return one.first <= 0 || m_levels.contains(one.first);
  });
}

ScaledShape LineScales::nearest(const model::SurfacePtr& surface, float level) const {
  const std::lock_guard lock(m_mutex);
  ScaledShape nearest{surface};
  float least = std::abs(level);
  for (const auto& [which, shape] : m_levels)
    if (const float away = std::abs(level - float(which)); away < least) {
      least = away;
      nearest = {shape, 1.0f, thresholdOf(*surface, which)};
    }
  return nearest;
}

model::SurfacePtr LineScales::level(const model::SurfacePtr& surface, int level) {
  if (level <= 0)
    return surface;
  const std::lock_guard lock(m_mutex);
  if (const auto known = m_levels.find(level); known != m_levels.end())
    return known->second;
  if (m_levels.size() >= mostLevels) {
    const bool lowIsFarther = level - m_levels.begin()->first > m_levels.rbegin()->first - level;
    m_levels.erase(lowIsFarther ? m_levels.begin() : std::prev(m_levels.end()));
  }
  model::SurfacePtr made;
  isolated([&] {
    const model::Mesh& source = m_finer.mesh ? *m_finer.mesh : *surface->mesh;
    const model::MeshPtr shape = model::withoutSmallForms(source, deviationOf(*surface, level));
    made = m_finer.mesh ? model::reshapedSurface(*surface, *shape, m_finer.vertices)
                        : model::reshapedSurface(*surface, *shape);
  });
  return m_levels.emplace(level, std::move(made)).first->second;
}

}  // namespace sline::render
