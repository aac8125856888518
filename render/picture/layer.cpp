// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "model/base/parallel.h"
#include "render/drawn/surface_fill.h"
#include "render/picture/printed_hatching.h"
#include "render/picture/surfaces/visible_triangles.h"
#include "render/strokes/coverage.h"
#include "render/strokes/hidden_lines.h"

namespace sline::render {

namespace {

/// Returns the region with the pixels beside it that may be looked at.
PixelRect withStrokeReach(const PreparedStructure& shown, const PictureView& view,
                          const PixelRect& region) {
  const int around = strokeReach(shown, view);
  return grown(region,
               shown.printedHatching ? std::max(around, printedHatchingReach(view)) : around);
}

/// Returns whether something of it is hidden, and not marked.
bool markSurface(const PreparedStructure& shown, const PictureView& view,
                 const Occlusion* occlusion, TileMask& mask) {
  const bool cull = cullsBack(shown, view);
  bool hidden = false;
  for (const model::Cluster& cluster : shown.surface().clusters.items) {
    if ((cull && model::facing(cluster, view.eye()) == model::Facing::back) ||
        isCutAway(shown, cluster.bounds))
      continue;
    if (occlusion && occlusion->hides(shown.surface(), cluster, edgeMargin))
      hidden = true;
    else
      mask.mark(grown(view.bounds(cluster.bounds), edgeMargin));
  }
  return hidden;
}

/// Returns how far the strokes' tests look at the surface.
int testReach(const PreparedStructure& shown, const PictureView& view, int step) {
  return strokeReach(shown, view) + 2 * (step - 1);
}

/// Marks so many pixels around what strokes draw on.
void markReach(const std::vector<Stroke>& strokes, int reach, TileMask& mask) {
  for (const Stroke& stroke : strokes)
    mask.mark(grown(strokeBounds(stroke), reach));
}

/// Marks what strokes draw on as shown, and so many pixels around it as touched.
void markStrokes(const std::vector<Stroke>& strokes, int reach, Layer& layer) {
  for (const Stroke& stroke : strokes) {
    const PixelRect bounds = strokeBounds(stroke);
    layer.mask.mark(bounds);
    layer.touched.mark(grown(bounds, reach));
  }
}

/// Returns where surfaces of the region are sampled.
SampleGrid sampleGrid(const PixelRect& region, int step) {
  const auto within = [step](int pixels) { return (pixels % step + step) % step; };
  return {{within(region.x), within(region.y)}, step};
}

}  // namespace

SurfacePlace surfacePlace(const Layer& layer, const PixelRect& slot) {
  const int step = layer.surfaceStep;
  const PixelRect coarse = coarser(slot, step);
  return {{layer.area.x - slot.x + step * coarse.x, layer.area.y - slot.y + step * coarse.y,
           step * coarse.width, step * coarse.height},
          coarse};
}

SampleArea sampledArea(const Layer& layer, const PixelRect& region) {
  const SampleGrid grid = sampleGrid(region, layer.surfaceStep);
  const SurfacePlace place = surfacePlace(layer, layer.slot);
  const PixelRect samples{(place.pixels.x - grid.corner.x) / grid.step,
                          (place.pixels.y - grid.corner.y) / grid.step, place.slot.width,
                          place.slot.height};
  assert(grid.corner.x + grid.step * samples.x == place.pixels.x &&
         grid.corner.y + grid.step * samples.y == place.pixels.y);
  return {grid, samples};
}

void findTriangles(Layer& layer, const PictureView& view, const PixelRect& region) {
  const SampleGrid grid = sampleGrid(region, layer.surfaceStep);
  layer.triangles.resize(layer.members.size());
  parallelFor(layer.members.size(), 1, [&](std::size_t i) {
    const PreparedStructure& shown = layer.members[i];
    if (!isCutAway(shown, shown.mesh->bounds()))
      layer.triangles[i] = visibleTriangles(shown, view, layer.touched, grid);
  });
}

std::vector<Layer> planLayers(std::span<const PreparedStructure> shown, const PictureView& view,
                              const PixelRect& region, const PictureContent& parts) {
  std::vector<PixelRect> found(shown.size());
  parallelFor(shown.size(), 1, [&](std::size_t i) {
    if (!shown[i].buried)
      found[i] = coveredArea(shown[i], view, withStrokeReach(shown[i], view, region));
  });
  // The layer of all opaque structures comes first: its depths win ties.
  std::vector<Layer> layers(1);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (found[i].empty())
      continue;
    // Cut faces have outlines, so a cut structure has a layer of its own.
    const bool opaque = isOpaque(shown[i].style) && !shown[i].cut;
    if (!opaque)
      layers.emplace_back();
    Layer& layer = opaque ? layers.front() : layers.back();
    layer.area = united(layer.area, found[i]);
    layer.members.push_back(shown[i]);
    layer.parts = parts;
    layer.filled = parts.fills && (hasFill(shown[i].style) || hasCaps(shown[i]));
  }
  if (layers.front().members.empty())
    layers.erase(layers.begin());
  return layers;
}

void completeLayer(Layer& layer, const PictureView& view, const PixelRect& region,
                   const std::map<model::NodeId, StructureLines>& lines,
                   const Occlusion* occlusion) {
  layer.mask = TileMask(region, layer.area);
  for (const PreparedStructure& member : layer.members)
    if (((layer.parts.fills && hasFill(member.style)) || member.printedHatching) &&
        markSurface(member, view, occlusion, layer.mask))
      layer.partial = true;
  if (occlusion && layer.sampled && occlusion->unmarkHidden(layer.pixels, layer.mask))
    layer.partial = true;
  for (const PreparedStructure& member : layer.members)
    if (layer.parts.fills && hasCaps(member))
      markCaps(member, view, layer.mask);
  // Enlarged fills are trimmed along contours, also where these themselves are hidden, but not all
  // around them.
  const auto trims = [&](const model::Surface& surface, const Stroke& stroke) {
    const int reach = layer.surfaceStep + 1;
    return layer.filled && layer.surfaceStep > 1 && stroke.kind == StrokeKind::contour &&
           layer.mask.marksAny(grown(strokeBounds(stroke), reach)) &&
           !occlusion->hides(surface, stroke, reach);
  };
  const auto leaveOutHidden = [&](const model::Surface& surface, std::vector<Stroke>& strokes) {
    if (occlusion && std::erase_if(strokes, [&](const Stroke& stroke) {
                       return occlusion->hides(surface, stroke) && !trims(surface, stroke);
                     }) > 0)
      layer.partial = true;
  };
  layer.touched = layer.mask;
  layer.edges.resize(layer.members.size());
  for (std::size_t i = 0; i < layer.members.size(); ++i) {
    const PreparedStructure& member = layer.members[i];
    if (layer.parts.fills && showsEdges(member.style))
      layer.edges[i] =
          edges(member.surface(), view, member.style, lines.at(member.id).lines, layer.area);
    leaveOutHidden(member.surface(), layer.edges[i]);
    markReach(layer.edges[i], testReach(member, view, layer.surfaceStep), layer.touched);
  }
  const PreparedStructure& first = layer.members.front();
  layer.inked = first.printedHatching;
  const PictureContent& parts = layer.parts;
  const bool pens = (parts.lines || parts.hatching) && showsLines(first.style);
  if (!pens && !(parts.lines && first.cut))
    return;
  const StructureLines& drawn = lines.at(first.id);
  layer.strokes =
      strokes(first.surface(), view, first.style,
              parts.lines ? drawn : StructureLines{.hatching = drawn.hatching}, layer.area);
  leaveOutHidden(first.surface(), layer.strokes);
  layer.inked = layer.inked || !layer.strokes.empty();
  if (parts.lines) {
    layer.hidden = hiddenStrokes(first.surface(), view, first.style, drawn, layer.area);
    layer.halos = haloStrokes(first.surface(), view, first.style, drawn, layer.area);
  }
  layer.hiddenInk = !layer.hidden.empty();
  layer.haloed = !layer.halos.empty();
  for (const std::vector<Stroke>* strokes : {&layer.strokes, &layer.hidden, &layer.halos})
    markStrokes(*strokes, testReach(first, view, layer.surfaceStep), layer);
}

}  // namespace sline::render
