// SPDX-License-Identifier: Apache-2.0
#include "render/picture/detail_levels.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/geometry/coarsening.h"
#include "model/geometry/edge_length.h"
#include "render/picture/surface_cache.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

namespace {

// How long edges may be on an average. At 1.3 pixels a few suggestive contours end sooner, and
// crumbs appear beside contours: a moving camera hides that, a still picture does not.
constexpr float stillPixels = 0.75f;
constexpr float movingPixels = 1.5f;
/// How long edges of what is sampled may be, in samples. What is left out lies off by a sixth of
/// that at most, half a sample, where the surface is bent most.
constexpr float sampledEdge = 3.0f;

/// Returns how many mm a pixel shows where the structure's box is nearest; 0 where that may lie
/// beside the eye.
float leastPixel(const DrawnStructure& shown, const PictureView& view) {
  float least = std::numeric_limits<float>::infinity();
  for (const glm::vec3& corner : shown.mesh->bounds().corners())
    least = std::min(least, view.millimetresPerPixel(corner));
  return std::max(least, 0.0f);
}

}  // namespace

Coarseness allowedCoarseness(const DrawnStructure& shown, const PictureView& view,
                             const PictureSettings& settings) {
  Coarseness allowed{.edge = 0.0f, .hurried = settings.hurried};
  if (gammaVaries(shown.style))
    return allowed;
  // Hatching would change at rest, and sections would be cut anew.
  const bool moving = (settings.hurried || settings.surfaceStep > 1) &&
                      !showsHatching(shown.style) && shown.sections.empty();
  allowed.edge = leastPixel(shown, view) * (moving ? movingPixels : stillPixels);
  return allowed;
}

Coarseness sampledCoarseness(const DrawnStructure& shown, const PictureView& view,
                             const PictureSettings& settings) {
  return {.edge = leastPixel(shown, view) * sampledEdge * float(settings.surfaceStep),
          .hurried = settings.hurried};
}

DetailLevels::DetailLevels() = default;
DetailLevels::~DetailLevels() = default;
DetailLevels::DetailLevels(DetailLevels&&) noexcept = default;
DetailLevels& DetailLevels::operator=(DetailLevels&&) noexcept = default;

DetailLevels::Level DetailLevels::levelOf(model::MeshPtr mesh) {
  const float edge = model::meanEdgeLength(mesh->positions(), mesh->triangles());
  return {.mesh = std::move(mesh), .edge = edge, .cached = std::make_unique<CachedSurface>()};
}

bool DetailLevels::ready(std::size_t level) const {
  return m_levels[level].cached->surface != nullptr;
}

std::size_t DetailLevels::wanted(const Coarseness& allowed) {
  const bool keepsAsItIs =
      allowed.hurried && std::any_of(m_levels.begin(), m_levels.end(), [](const Level& level) {
        return level.cached->surface != nullptr;
      });
  std::size_t level = 0;
  while (true) {
    const bool last = level + 1 == m_levels.size();
    if (last && keepsAsItIs)
      return level;
    if (last && !m_complete && LevelStep::growth * m_levels[level].edge <= allowed.edge) {
      const model::MeshPtr& mesh = m_levels[level].mesh;
      model::MeshPtr coarser =
          mesh->triangleCount() < leastTriangles
              ? mesh
              : model::coarsened(mesh, LevelStep::collapsed * m_levels[level].edge);
      m_complete =
          !(float(coarser->triangleCount()) < LevelStep::worthwhile * float(mesh->triangleCount()));
      if (!m_complete)
        m_levels.push_back(levelOf(std::move(coarser)));
    }
    if (level + 1 == m_levels.size() || m_levels[level + 1].edge > allowed.edge)
      return level;
    ++level;
  }
}

CachedSurface& DetailLevels::at(const model::MeshPtr& mesh, const model::Provenance& provenance,
                                const Coarseness& allowed) {
  if (m_levels.empty())
    m_levels.push_back(levelOf(pictureMesh(mesh, provenance)));
  std::size_t level = wanted(allowed);
  if (allowed.hurried && !ready(level)) {
    // The finest that is ready and not finer than wanted, or else the coarsest of the finer ones.
    std::size_t other = level;
    while (other < m_levels.size() && !ready(other))
      ++other;
    if (other == m_levels.size())
      for (other = level; other > 0 && !ready(other);)
        --other;
    level = ready(other) ? other : level;
  }
  Level& chosen = m_levels[level];
  if (!ready(level))
    chosen.cached->takeShown(chosen.mesh, provenance);
  return *chosen.cached;
}

}  // namespace sline::render
