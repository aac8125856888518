// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/line_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/fairing/faired.h"

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

float deviationOf(const model::Surface& surface, int level) {
  return levelZero * surface.meanEdge * std::exp2(float(level));
}

}  // namespace

float scaleDeviation(const model::Surface& surface, const PictureView& view, float lineScale,
                     float known) {
  const float mm = view.millimetresPerPixel(surface.boundingSphere.centre) * view.outputUnit();
  const float wanted = std::min(lineScale * usualScale * mm, largestShare * surface.featureSize);
  return std::sqrt(std::max(wanted * wanted - known * known, 0.0f));
}

std::vector<ScaledShape> LineScales::at(const model::SurfacePtr& surface, float deviation) {
  const float at = deviation > 0.0f && surface->meanEdge > 0.0f
                       ? std::log2(deviation / deviationOf(*surface, 0))
                       : 0.0f;
  if (!(at > fadeFrom))
    return {{surface}};
  const int low = int(std::floor(at));
  const float t = std::clamp((at - float(low) - fadeFrom) / (fadeTo - fadeFrom), 0.0f, 1.0f);
  std::vector<ScaledShape> shapes;
  const auto add = [&](int which, float share) {
    if (share > 0.0f)
      shapes.push_back(
          {level(surface, which), share,
           std::max(1.0f, deviationOf(*surface, which) / (trustedShare * surface->featureSize))});
  };
  add(low, 1.0f - t);
  add(low + 1, t);
  return shapes;
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
  const model::MeshPtr shape =
      model::withoutSmallForms(*surface->mesh, deviationOf(*surface, level));
  return m_levels.emplace(level, model::reshapedSurface(*surface, *shape)).first->second;
}

}  // namespace sline::render
