// SPDX-License-Identifier: Apache-2.0
// Draws a structure's outlines into its cells where the pen draws them: as smoothed curves, which
// lie beside the surface's own edge.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/drawn/section_caps.h"
#include "render/drawn/sectioned_surface.h"
#include "render/labels/seen/seen_layer.h"
#include "render/lines/ground/stages.h"
#include "render/sight/contour_look.h"

namespace sline::render {

namespace {

/// Returns the key's distance from the eye's plane, mm.
float distanceOf(float key, bool perspective) {
  return perspective ? -1.0f / key : key;
}

/// Returns the key that much nearer to the eye.
float lifted(float key, float mm, bool perspective) {
  const float to =
      rule::liftedDistance(distanceOf(key, perspective), mm, perspective ? 1.0f : 0.0f);
  return perspective ? -1.0f / to : to;
}

}  // namespace

float SeenLayer::distanceAt(const glm::vec2& cell) const {
  const int x = int(std::floor(cell.x));
  const int y = int(std::floor(cell.y));
  return covers(x, y) ? distanceOf(at(x, y).depth, m_perspective)
                      : std::numeric_limits<float>::max();
}

bool SeenLayer::showsAt(PenPoint& point, const ContourProbes& probes, float tolerance) const {
  const std::optional<int> look =
      contourLook({distanceOf(point.depth, m_perspective), tolerance, probes.sheet, probes.reach},
                  [&](float outside) { return distanceAt(point.on + outside * point.outward); });
  if (!look)
    return false;
  const glm::vec2 beyond =
      point.on + rule::probeOutside(*look, probes.probe, probes.reach) * point.outward;
  if (covers(int(std::floor(beyond.x)), int(std::floor(beyond.y)))) {
    const float share = innerContourShare(m_style) * transitions(m_style.gamma).contours;
    point.opacity *= rule::penOpacity(share * point.halfWidth);
    point.halfWidth = rule::penHalfWidth(share * point.halfWidth);
  }
  return true;
}

void SeenLayer::takeInk(const PenPoint& point, std::vector<float>& depths) {
  const glm::vec2 middle = point.place + rule::penOutside(point.halfWidth) * point.outward;
  const float reach = point.halfWidth + 0.5f;
  for (int y = int(std::floor(middle.y - reach)); y <= int(std::floor(middle.y + reach)); ++y)
    for (int x = int(std::floor(middle.x - reach)); x <= int(std::floor(middle.x + reach)); ++x) {
      if (x < m_left || y < m_top || x >= m_left + m_columns || y >= m_top + m_rows)
        continue;
      const float off = glm::length(glm::vec2(x, y) + 0.5f - middle);
      const float ink = rule::penCoverage(point.halfWidth, off, 1.0f) * point.opacity;
      constexpr float least = 0.002f;
      if (ink <= least)
        continue;
      const std::size_t i = index(x, y);
      depths[i] = std::min(depths[i], point.lifted);
      SeenCell& cell = m_cells[i];
      if (ink <= cell.ink)
        continue;
      if (cell.what == SeenCell::What::nothing)
        cell = {.depth = point.lifted, .facing = 0.0f, .what = SeenCell::What::beside};
      cell.outline = true;
      cell.ink = ink;
    }
}

void SeenLayer::drawCurves(const StructureLines& drawn, const model::Surface& surface,
                           const Screen& screen, const PictureView& view) {
  const float lines = transitions(m_style.gamma).lines;
  const float pen = penWidth(surface, view, m_style.penWeight);
  const ContourProbes probes = contourProbes(surface, view, m_style);
  // Columns are rounded up, so that the view's middle may lie beside the screen's.
  const float aside = 0.5f * (view.size().x - screen.size().x / m_side);
  const auto cellOf = [&](const glm::vec3& p) {
    const glm::vec2 pixel = view.project(p).pixel;
    return glm::vec2(pixel.x - aside, view.size().y - pixel.y);
  };
  std::vector<float> depths(m_cells.size(), std::numeric_limits<float>::max());
  const auto draw = [&](const Segment& s, float width, bool outside) {
    if (!screen.place(s.a) || !screen.place(s.b))
      return;
    const glm::vec2 from = cellOf(s.a);
    const glm::vec2 to = cellOf(s.b);
    const glm::vec2 fromPlace = cellOf(s.a + s.moveA);
    const glm::vec2 toPlace = cellOf(s.b + s.moveB);
    const glm::vec2 out = view.projectedDirection(s.a, s.normalA) +
                          view.projectedDirection(s.b, s.normalB) + glm::vec2(1e-6f, 0.0f);
    const glm::vec2 outward = glm::normalize(glm::vec2(out.x, -out.y));
    const float tolerance = 0.5f * surface.meanEdge + 1e-3f * surface.filigreeSize +
                            (outside ? 0.0f : 3.0f * view.millimetresPerPixel(s.a));
    const int steps = std::clamp(int(std::ceil(2.0f * glm::length(toPlace - fromPlace))), 1, 200);
    for (int k = 0; k <= steps; ++k) {
      const float t = float(k) / float(steps);
      const float depth = glm::mix(screen.depthKey(s.a), screen.depthKey(s.b), t);
      const float full = width * lines * glm::mix(s.pressureA, s.pressureB, t);
      PenPoint point{
          .on = glm::mix(from, to, t),
          .place = glm::mix(fromPlace, toPlace, t),
          .outward = outward,
          .depth = depth,
          .lifted = outside ? lifted(depth, 2.0f * tolerance, m_perspective)
                            : inFront(depth, outlineSteps),
          .halfWidth = rule::penHalfWidth(0.5f * full),
          .opacity = lines * glm::mix(s.opacityA, s.opacityB, t) * rule::penOpacity(0.5f * full)};
      if (!showsAt(point, probes, tolerance))
        continue;
      if (!outside)
        point.outward = glm::vec2(0.0f);
      takeInk(point, depths);
    }
  };
  for (const Segment& s : drawn.lines[LineKind::contour])
    draw(s, pen, true);
  for (const Segment& s : drawn.lines[LineKind::section])
    draw(s, 0.5f * pen, false);
  for (std::size_t i = 0; i < m_cells.size(); ++i)
    if (m_cells[i].ink > 0.0f)
      m_cells[i].depth = std::min(m_cells[i].depth, depths[i]);
}

model::SurfacePtr SeenLayer::pictured() const {
  // Outlines need no curvature that is averaged over rings, which takes most of the time.
  model::Provenance provenance = m_node->provenance;
  provenance.smoothingSteps = 0;
  provenance.refinementSteps = 0;
  return pictureSurface(m_node->mesh, provenance);
}

void SeenLayer::takeSurface(model::SurfacePtr surface) {
  m_surface = std::move(surface);
  m_mesh = m_surface->mesh;
}

void SeenLayer::drawAsInPictures(const model::Scene& scene, const Screen& screen,
                                 const SeenGrid& grid) {
  PreparedSurface prepared;
  prepared.surface = m_surface;
  draw(scene, screen, grid);
  for (SeenCell& cell : m_cells) {
    cell.ink = 0.0f;
    if (cell.what == SeenCell::What::beside)
      cell = {};
  }
  if (!showsLines(m_style) || m_cells.empty())
    return;
  const PictureView view(screen.camera(), scene.visibleBounds(), grid.columns, grid.rows);
  model::ResolvedStyle style = m_style;
  style.gamma = Gamma::clamped(std::min(style.gamma.value(), 1.0f));
  StructureLines drawn;
  drawn.lines = styledLines(prepared, view, style);
  if (!m_planes.empty())
    cutLines(sectioned(prepared.surface, m_planes), drawn);
  joinLines(*prepared.surface, view, style, scene.keyLight().value_or(model::KeyLight()).towards,
            drawn);
  drawCurves(drawn, *prepared.surface, screen, view);
}

}  // namespace sline::render
