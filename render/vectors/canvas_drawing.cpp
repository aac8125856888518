// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/canvas_drawing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "model/base/parallel.h"
#include "render/sight/rules.h"
#include "render/strokes/hidden_lines.h"
#include "render/strokes/surface_fill.h"
#include "render/vectors/depth_layer.h"
#include "render/vectors/ink_chains.h"
#include "render/vectors/layer_stack.h"
#include "render/vectors/pen_shapes.h"

namespace sline::render {

namespace {

// Along a stroke of varying width, the pixels that are drawn with one width.
constexpr std::size_t evenPiece = 5;
// Strokes thinner than this are drawn fainter instead: canvases blur them.
constexpr float thinnestLine = 0.6f;
constexpr double canvasPixelsPerTone = 6.0;

/// Collects strokes of one structure.
class CanvasPen {
 public:
  CanvasPen(std::vector<CanvasStroke>& strokes, float height)
      : m_strokes(strokes), m_height(height) {}

  void add(const VisibleStroke& stroke, const Colour& ink, float opacity) {
    const Colour colour = behind(stroke.veil, ink);
    const std::span<const StrokePoint> points(stroke.points);
    if (isEven(points)) {
      put(points, colour, opacity);
      if (stroke.closed)
        m_strokes.back().points.push_back(m_strokes.back().points.front());
      return;
    }
    for (std::size_t first = 0; first + 1 < points.size(); first += evenPiece)
      put(points.subspan(first, std::min(evenPiece + 1, points.size() - first)), colour, opacity);
    if (points.size() == 1)
      put(points, colour, opacity);
  }

 private:
  void put(std::span<const StrokePoint> points, const Colour& colour, float opacity) {
    const float width = meanWidth(points);
    CanvasStroke& stroke = m_strokes.emplace_back();
    stroke.colour = colour;
    stroke.width = std::max(width, thinnestLine);
    stroke.opacity = opacity * std::min(1.0f, width / thinnestLine);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i % 2 == 0 || i + 1 == points.size())  // every other pixel is enough for a curve
        stroke.points.emplace_back(points[i].at.x, m_height - points[i].at.y);
    if (stroke.points.size() == 1)
      stroke.points.push_back(stroke.points.front() + glm::vec2(0.01f, 0.0f));
  }

  std::vector<CanvasStroke>& m_strokes;
  float m_height;
};

/// Paints the fills on the ground, as the resolve pass does.
void paintFills(const LayerStack& stack, const glm::vec4& ground, CanvasDrawing& drawing) {
  drawing.rgba.resize(std::size_t(drawing.width) * std::size_t(drawing.height) * 4);
  parallelFor(std::size_t(drawing.height), 16, [&](std::size_t row) {
    std::vector<SeenFill> fills;
    const int y = drawing.height - 1 - int(row);
    std::uint8_t* out = drawing.rgba.data() + row * std::size_t(drawing.width) * 4;
    for (int x = 0; x < drawing.width; ++x, out += 4) {
      stack.seenAt(x, y, fills);
      glm::vec4 sum(0.0f);
      for (const SeenFill& fill : fills)
        sum = laidBehind(sum, fill.colour);
      sum = laidBehind(sum, ground);
      for (int c = 0; c < 4; ++c)
        out[c] = std::uint8_t(std::lround(255.0f * std::clamp(sum[c], 0.0f, 1.0f)));
    }
  });
}

/// Draws one structure's lines; `layers` are those of all structures.
struct StructurePen {
  const PictureView& view;
  std::span<const DepthLayer> layers;
  const LayerStack& stack;
  Background background;

  StrokeScene sceneOf(const StructureWork& work, std::size_t index, float ink) const {
    return {.stack = stack,
            .own = layers[index],
            .ownIndex = index,
            .projection = view.depthTerms(),
            .probes = contourProbes(work.shown.surface(), view, work.shown.style),
            .ink = ink};
  }

  std::vector<CanvasStroke> draw(StructureWork& work, std::size_t index) const {
    std::vector<CanvasStroke> strokes;
    if (!work.hasLines())
      return strokes;
    const model::ResolvedStyle& style = work.shown.style;
    const Colour ink = inkColour(style, background);
    CanvasPen pen(strokes, view.size().y);
    const float even = evenInk(style);
    StrokeScene behindOthers = sceneOf(work, index, even);
    behindOthers.hidden = true;
    for (const InkChain& chain :
         inkChains(hiddenStrokes(work.shown.surface(), view, style, work.lines, work.area)))
      for (const VisibleStroke& stroke :
           withinPage(visibleStrokes(chain, behindOthers), view.size()))
        pen.add(stroke, ink, rule::hiddenShare * even);
    for (const LineLayer& layer : takeLayers(work))
      for (const VisibleStroke& stroke :
           seenLines(work, layer.lines, sceneOf(work, index, layer.opacity), view))
        pen.add(stroke, ink, layer.opacity);
    return strokes;
  }
};

}  // namespace

CanvasDrawing CanvasDrawer::draw(const model::Scene& scene, const model::Camera& camera,
                                 const PictureSettings& settings) {
  CanvasDrawing drawing{
      .width = settings.width, .height = settings.height, .rgba = {}, .strokes = {}};
  std::vector<StructureWork> work = structureWork(scene, m_surfaces);
  m_surfaces.keepOnly(scene);
  model::Box bounds;
  for (const StructureWork& one : work)
    bounds.add(one.shown.mesh->bounds());
  const PictureView view(camera, bounds, settings.width, settings.height);
  findAreas(work, view);
  std::erase_if(work, [](const StructureWork& one) { return one.area.empty(); });
  prepareLines(work);
  const model::KeyLight own = scene.keyLight().value_or(model::KeyLight());
  const glm::vec3 light = settings.environment.light.value_or(own.towards);
  const glm::vec3 keyLight =
      settings.environment.keyLight.value_or(own.shades) ? view.toPatient(light) : glm::vec3(0.0f);
  const LayerInput input{view, settings.environment.background, keyLight, canvasPixelsPerTone};
  std::vector<DepthLayer> layers(work.size());
  parallelFor(work.size(), 1, [&](std::size_t i) {
    findLines(work[i], view, light);
    layers[i] = depthLayer(work[i].shown, input, work[i].area);
  });
  const LayerStack stack(layers, view.size());
  paintFills(stack, backgroundColour(settings.environment.background), drawing);
  const StructurePen pen{view, layers, stack, settings.environment.background};
  std::vector<std::vector<CanvasStroke>> strokes(work.size());
  parallelFor(work.size(), 1, [&](std::size_t i) { strokes[i] = pen.draw(work[i], i); });
  for (std::vector<CanvasStroke>& some : strokes)
    std::move(some.begin(), some.end(), std::back_inserter(drawing.strokes));
  return drawing;
}

}  // namespace sline::render
