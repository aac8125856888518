// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "render/picture/printed_hatching.h"
#include "render/picture/transitions.h"

namespace sline::render {

namespace {

constexpr float tintStrength = 0.2f;
// Of what lies behind one veil two fifths show, behind two a sixth: near and far stay apart.
constexpr float veilStrength = 0.6f;
// Pixels that a fill reaches beyond its surface, soft edge included.
constexpr int edgeMargin = 2;

bool cullsBack(const Shown& shown, const PictureView& view) {
  return !needsTwoSides(shown.surface(), view.camera());
}

/// Pixels around the surface that strokes and their looks aside can reach.
int margin(const Shown& shown, const PictureView& view) {
  if (!showsLines(shown.style) && !showsEdges(shown.style))
    return edgeMargin;
  const ContourProbes probes = contourProbes(shown.surface(), view, shown.style);
  return int(std::ceil(2.0f * probes.probe + probes.reach.y)) + 3;
}

gpu::Rect unite(const gpu::Rect& a, const gpu::Rect& b) {
  if (a.empty())
    return b;
  if (b.empty())
    return a;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.top(), b.top()) - y};
}

void markSurface(const Shown& shown, const PictureView& view, TileMask& mask) {
  const bool cull = cullsBack(shown, view);
  for (const model::Cluster& cluster : shown.surface().clusters.items)
    if ((!cull || model::facing(cluster, view.eye()) != model::Facing::back) &&
        !takenAway(shown, cluster.bounds))
      mask.mark(gpu::grown(view.bounds(cluster.bounds), edgeMargin));
}

}  // namespace

glm::vec4 backgroundColour(Background background) {
  switch (background) {
    case Background::white:
      return {1.0f, 1.0f, 1.0f, 1.0f};
    case Background::paper:
      return {glm::vec3(250.0f, 246.0f, 236.0f) / 255.0f, 1.0f};
    case Background::dark:
      return {glm::vec3(28.0f, 30.0f, 34.0f) / 255.0f, 1.0f};
    case Background::transparent:
      break;
  }
  return {0.0f, 0.0f, 0.0f, 0.0f};
}

Colour inkColour(const model::ResolvedStyle& style, Background background) {
  if (style.inkColour)
    return *style.inkColour;
  return background == Background::dark ? Colour{238, 236, 230} : Colour{0, 0, 0};
}

bool isOpaque(const model::ResolvedStyle& style) {
  return transitions(style.gamma).complete >= 1.0f && style.opacity.value() >= 1.0f;
}

bool hasFill(const model::ResolvedStyle& style) {
  return style.opacity.value() > 0.0f &&
         (style.fill != model::Fill::none || transitions(style.gamma).shading > 0.0f);
}

passes::SurfaceFill surfaceFill(const Shown& shown, const PictureView& view,
                                Background background) {
  using Kind = passes::SurfaceFill::Kind;
  const model::ResolvedStyle& style = shown.style;
  const Transitions t = transitions(style.gamma);
  passes::SurfaceFill fill;
  if (!hasFill(style))
    return fill;
  fill.kind = t.shading > 0.0f ? Kind::phong : Kind::flat;
  fill.colour = rgb(style.colour);
  fill.shading = t.shading;
  fill.complete = t.complete;
  fill.opacity = style.opacity.value();
  fill.filigree = shown.surface().filigreeSize;
  fill.darkGround = background == Background::dark;
  fill.twoSided = !cullsBack(shown, view);
  if (style.fill == model::Fill::paper || style.fill == model::Fill::veil) {
    // A picture without background is meant for white paper.
    const bool transparent = background == Background::transparent;
    fill.wash = transparent ? glm::vec4(1.0f) : backgroundColour(background);
    if (style.fill == model::Fill::veil)
      fill.wash *= veilStrength;
  } else if (style.fill == model::Fill::tint) {
    fill.wash = tintStrength * glm::vec4(fill.colour, 1.0f);
  }
  fill.wash *= fill.opacity;
  return fill;
}

namespace {

/// Appends the cluster's triangles that turn their outside to the eye. Software drivers shade
/// vertices on one thread, and this leaves them half the work; a graphics card hardly minds.
void appendFacing(const model::Surface& surface, const model::Cluster& cluster,
                  const model::EyePoint& eye, std::vector<std::uint32_t>& visible) {
  const bool all = model::facing(cluster, eye) == model::Facing::front;
  const auto positions = surface.mesh->positions();
  for (std::uint32_t i = 0; i < cluster.triangleCount; ++i) {
    const auto& [a, b, c] =
        surface.mesh->triangles()[surface.clusters.triangles[cluster.firstTriangle + i]];
    if (!all) {
      const glm::vec3 p = positions[a];
      const glm::vec3 toEye = eye.atInfinity ? eye.value : eye.value - p;
      if (!(glm::dot(glm::cross(positions[b] - p, positions[c] - p), toEye) > 0.0f))
        continue;
    }
    visible.insert(visible.end(), {a, b, c});
  }
}

void appendRange(const model::Cluster& cluster, std::vector<gpu::DrawRange>& ranges) {
  const gpu::DrawRange range{3 * cluster.firstTriangle, 3 * cluster.triangleCount};
  if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first)
    ranges.back().count += range.count;
  else
    ranges.push_back(range);
}

/// The clusters that may show within the region, each with the pixels it can touch.
template <class Body>
void forEachSeen(const Shown& shown, const PictureView& view, const gpu::Rect& region,
                 const Body& body) {
  const bool cull = cullsBack(shown, view);
  const int around = margin(shown, view);
  const int aside = shown.printedHatching ? std::max(around, printedHatchingReach(view)) : around;
  const gpu::Rect within = gpu::grown(region, aside);
  for (const model::Cluster& cluster : shown.surface().clusters.items) {
    if ((cull && model::facing(cluster, view.eye()) == model::Facing::back) ||
        takenAway(shown, cluster.bounds))
      continue;
    const gpu::Rect seen =
        gpu::intersection(gpu::grown(view.bounds(cluster.bounds), around), within);
    if (!seen.empty())
      body(cluster, seen);
  }
}

}  // namespace

Coverage coverage(const Shown& shown, const PictureView& view, const gpu::Rect& region) {
  Coverage found;
  if (takenAway(shown, shown.mesh->bounds()))
    return found;
  const bool cull = cullsBack(shown, view);
  forEachSeen(shown, view, region, [&](const model::Cluster& cluster, const gpu::Rect& seen) {
    found.area = unite(found.area, seen);
    if (!cull)
      appendRange(cluster, found.ranges);
  });
  if (shown.cut) {
    const int around = margin(shown, view);
    const int aside = shown.printedHatching ? std::max(around, printedHatchingReach(view)) : around;
    found.area = unite(found.area, gpu::intersection(gpu::grown(sectionArea(shown, view), around),
                                                     gpu::grown(region, aside)));
  }
  return found;
}

void findVisible(Layer& layer, const PictureView& view, const gpu::Rect& region) {
  for (std::size_t i = 0; i < layer.members.size(); ++i) {
    const Shown& shown = layer.members[i];
    if (!cullsBack(shown, view) || takenAway(shown, shown.mesh->bounds()))
      continue;
    std::vector<std::uint32_t>& visible = layer.coverage[i].visible;
    visible.clear();
    forEachSeen(shown, view, region, [&](const model::Cluster& cluster, const gpu::Rect&) {
      appendFacing(shown.surface(), cluster, view.eye(), visible);
    });
  }
}

std::vector<Layer> planLayers(std::span<const Shown> shown, const PictureView& view,
                              const gpu::Rect& region, const PictureParts& parts) {
  std::vector<Coverage> found(shown.size());
  parallelFor(shown.size(), 1, [&](std::size_t i) { found[i] = coverage(shown[i], view, region); });
  // The layer of all opaque structures comes first: its depths win ties.
  std::vector<Layer> layers(1);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (found[i].area.empty())
      continue;
    // Cut faces have outlines, so what is cut has a layer of its own.
    const bool opaque = isOpaque(shown[i].style) && !shown[i].cut;
    if (!opaque)
      layers.emplace_back();
    Layer& layer = opaque ? layers.front() : layers.back();
    layer.area = unite(layer.area, found[i].area);
    layer.members.push_back(shown[i]);
    layer.coverage.push_back(std::move(found[i]));
    layer.parts = parts;
    layer.filled = parts.fills && (hasFill(shown[i].style) || hasCaps(shown[i]));
  }
  if (layers.front().members.empty())
    layers.erase(layers.begin());
  return layers;
}

void completeLayer(Layer& layer, const PictureView& view, const gpu::Rect& region,
                   const std::map<model::NodeId, StructureLines>& lines) {
  layer.mask = TileMask(region);
  layer.edges.resize(layer.members.size());
  for (std::size_t i = 0; i < layer.members.size(); ++i) {
    const Shown& member = layer.members[i];
    if ((layer.parts.fills && hasFill(member.style)) || member.printedHatching)
      markSurface(member, view, layer.mask);
    if (layer.parts.fills && hasCaps(member))
      markCaps(member, view, layer.mask);
    if (layer.parts.fills && showsEdges(member.style))
      layer.edges[i] = edges(member.surface(), view, lines.at(member.id).lines, layer.area);
  }
  const Shown& first = layer.members.front();
  layer.inked = first.printedHatching;
  const PictureParts& parts = layer.parts;
  const bool pens = (parts.lines || parts.hatching) && showsLines(first.style);
  if (!pens && !(parts.lines && first.cut))
    return;
  const StructureLines& drawn = lines.at(first.id);
  layer.strokes =
      strokes(first.surface(), view, first.style,
              parts.lines ? drawn : StructureLines{.hatching = drawn.hatching}, layer.area);
  layer.inked = layer.inked || !layer.strokes.empty();
  for (const passes::InkSegment& stroke : layer.strokes)
    layer.mask.mark(strokeBounds(stroke));
}

}  // namespace sline::render
