// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surfaces/detail_levels.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/geometry/coarsening.h"
#include "model/geometry/edge_length.h"
#include "render/picture/surfaces/surface_cache.h"
#include "render/strokes/structure_lines.h"

namespace sline::render {

namespace {

/// How long edges may be on an average, in pixels.
constexpr float shownEdge = 1.5f;
/// How long edges of what is sampled may be, in samples, where a surface is nearest. What is left
/// out lies off by a sixth of that at most, two thirds of a sample, where it is bent most.
constexpr float sampledEdge = 4.0f;

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
  const float edge = leastPixel(shown, view) * shownEdge * float(settings.samples);
  return {.edge = gammaVaries(shown.style) ? 0.0f : edge, .hurried = settings.hurried};
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

DetailLevels::Level DetailLevels::levelOf(model::MeshPtr mesh,
                                          std::vector<std::uint32_t> vertices) {
  const float edge = model::meanEdgeLength(mesh->positions(), mesh->triangles());
  return {.mesh = std::move(mesh),
          .vertices = std::move(vertices),
          .edge = edge,
          .cached = std::make_unique<CachedSurface>()};
}

bool DetailLevels::ready(std::size_t level) const {
  return m_levels[level].cached->surface != nullptr;
}

void DetailLevels::add() {
  const model::Mesh& mesh = *m_levels.back().mesh;
  m_complete = mesh.triangleCount() < leastTriangles;
  if (m_complete)
    return;
  model::CoarserMesh next = model::coarsened(mesh, LevelStep::collapsed * m_levels.back().edge);
  m_complete = !next.mesh || !(float(next.mesh->triangleCount()) <
                               LevelStep::worthwhile * float(mesh.triangleCount()));
  if (!m_complete)
    m_levels.push_back(levelOf(std::move(next.mesh), std::move(next.vertices)));
}

void DetailLevels::prepare(std::size_t level, const model::Provenance& provenance) {
  Level& chosen = m_levels[level];
  if (level == 0) {
    chosen.cached->takeShown(chosen.mesh, provenance);
    return;
  }
  // Its vertices are looked up in each finer level, until those of a prepared one or of the mesh
  // itself are known.
  model::SurfacePtr surface;
  model::FinerMesh finest{m_levels[0].mesh, chosen.vertices};
  for (std::size_t finer = level - 1;; --finer) {
    if (!surface && ready(finer))
      surface =
          model::prepareCoarser(chosen.mesh, *m_levels[finer].cached->surface, finest.vertices);
    if (finer == 0)
      break;
    for (std::uint32_t& vertex : finest.vertices)
      vertex = m_levels[finer].vertices[vertex];
  }
  if (!surface)
    surface = model::prepareCoarser(chosen.mesh, finest, pictureCurvature(provenance));
  chosen.cached->takeCoarser(std::move(surface), std::move(finest), provenance);
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
    if (last && !m_complete && LevelStep::growth * m_levels[level].edge <= allowed.edge)
      add();
    if (level + 1 == m_levels.size() || m_levels[level + 1].edge > allowed.edge)
      return level;
    ++level;
  }
}

CachedSurface& DetailLevels::at(const model::MeshPtr& mesh, const model::Provenance& provenance,
                                const Coarseness& allowed) {
  if (m_levels.empty())
    m_levels.push_back(levelOf(pictureMesh(mesh, provenance), {}));
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
  if (!ready(level))
    prepare(level, provenance);
  return *m_levels[level].cached;
}

}  // namespace sline::render
