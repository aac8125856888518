// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_ink.h"

#include <algorithm>

#include "render/drawn/surface_fill.h"
#include "render/picture/layer_content.h"

namespace sline::render {

namespace {

InkDraw inkDraw(const PictureInput& input, const Layer& layer, const PreparedStructure& shown) {
  ContourProbes probes = contourProbes(shown.surface(), input.view, shown.style);
  // Pixels of a surface with a step reach farther beyond its outline.
  const float more = float(input.surfaceStep - 1);
  probes.probe += more;
  probes.reach += more;
  return {.layer = layer.area,
          .slot = layer.slot,
          .surfaceStep = input.surfaceStep,
          .projection = input.view.depthTerms(),
          .probe = probes.probe,
          .reach = probes.reach,
          .grain = shown.style.grain,
          .grainSize = std::max(1.0f, paperGrain * input.view.outputUnit()),
          .sheet = probes.sheet};
}

/// Splits the layer's strokes at the first contour.
struct SplitStrokes {
  std::span<const Stroke> lines;
  std::span<const Stroke> contours;
};
SplitStrokes splitStrokes(const Layer& layer) {
  const std::span<const Stroke> all = layer.strokes;
  const std::size_t contours = firstContour(all);
  return {all.first(contours), all.subspan(contours)};
}

/// Lets the draw trim a fill that is enlarged. Within the strip along a contour, a few samples
/// wide, its surface may rise steeply.
void trimInstead(const PictureInput& input, const PreparedStructure& shown, InkDraw& draw) {
  constexpr float steepness = 4.0f;
  draw.kind = InkKind::trims;
  draw.sheet += steepness * float(draw.surfaceStep) *
                input.view.millimetresPerPixel(shown.surface().boundingSphere.centre);
}

}  // namespace

glm::vec3 keyLight(const PictureInput& input) {
  return input.keyLight ? input.light : glm::vec3(0.0f);
}

std::vector<InkDraw> edgeDraws(const PictureInput& input, const Layer& layer) {
  std::vector<InkDraw> draws;
  for (std::size_t k = 0; k < layer.members.size(); ++k) {
    const PreparedStructure& shown = layer.members[k];
    const SurfaceFill fill = shownFill(input, shown);
    InkDraw draw = inkDraw(input, layer, shown);
    // A fill that is enlarged is trimmed instead: its pixels have no edges to be softened.
    draw.kind = InkKind::edges;
    if (draw.surfaceStep > 1)
      trimInstead(input, shown, draw);
    draw.paint = glm::vec4(fill.colour, (fill.gammaOffsets ? 1.0f : fill.complete) * fill.opacity);
    draw.key = keyLight(input);
    draw.strokes = layer.edges[k];
    draws.push_back(draw);
  }
  if (layer.surfaceStep > 1 && layer.filled) {
    InkDraw draw = inkDraw(input, layer, layer.members.front());
    trimInstead(input, layer.members.front(), draw);
    draw.strokes = splitStrokes(layer).contours;
    draws.push_back(draw);
  }
  return draws;
}

std::vector<InkDraw> strokeDraws(const PictureInput& input, const Layer& layer) {
  std::vector<InkDraw> draws;
  InkDraw draw = inkDraw(input, layer, layer.members.front());
  const auto add = [&](InkKind kind, std::span<const Stroke> of) {
    draw.kind = kind;
    draw.strokes = of;
    draws.push_back(draw);
  };
  const auto [lines, contours] = splitStrokes(layer);
  // Halos first: their depth gives way to that of lines.
  add(InkKind::halos, layer.halos);
  add(InkKind::hidden, layer.hidden);
  add(InkKind::surfaceLines, lines);
  add(InkKind::contours, contours);
  return draws;
}

void forgetStrokes(Layer& layer) {
  layer.edges.assign(layer.edges.size(), {});
  for (std::vector<Stroke>* each : {&layer.halos, &layer.hidden, &layer.strokes})
    *each = {};
}

}  // namespace sline::render
