// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/vector_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "render/drawn/gamma_offsets.h"
#include "render/drawn/surface_fill.h"
#include "render/lines/ground/stages.h"
#include "render/sight/rules.h"
#include "render/strokes/hidden_lines.h"
#include "render/strokes/structure_lines.h"
#include "render/vectors/fill_shapes.h"
#include "render/vectors/paint_order.h"
#include "render/vectors/pen_shapes.h"
#include "render/vectors/structure_work.h"
#include "render/vectors/tone_images.h"
#include "render/vectors/visible_strokes.h"

namespace sline::render {

namespace {

// Depth is found in a picture of this height, three pixels to λ, unless that has more pixels than
// allowed.
constexpr float standardHeight = 2160.0f;
constexpr float mostPixels = 12e6f;
// The most pixels of all layers together, five bytes each.
constexpr double mostLayerPixels = 90e6;
// Files are to stay below 5 MB: outlines of fills may take the bytes that lines leave of this, but
// always at least the second number. The others are the bytes in SVG of a piece of a curve and of λ
// of a fill's outline.
constexpr double mostBytes = 4.4e6;
constexpr double leastFillBytes = 0.8e6;
constexpr double bytesPerPiece = 36.0;
constexpr double bytesPerOutline = 3.0;

/// The size of a picture in pixels.
struct PixelSize {
  int width = 1;
  int height = 1;
};

PixelSize pixelSize(const glm::vec2& sizeMm, float height) {
  const float aspect = sizeMm.x / sizeMm.y;
  const float h = std::min(height, std::sqrt(mostPixels / aspect));
  return {std::max(16, int(std::lround(h * aspect))), std::max(16, int(std::lround(h)))};
}

class Drawing {
 public:
  Drawing(const model::Scene& scene, const model::Camera& camera, const VectorSettings& settings,
          const VectorProgress& progress)
      : m_scene(scene), m_camera(camera), m_settings(settings), m_progress(progress) {}

  VectorDrawing make() {
    tell(0.0, "preparing surfaces");
    findShown();
    VectorDrawing drawing;
    drawing.sizeMm = m_settings.sizeMm;
    if (m_settings.environment.background != Background::transparent)
      drawing.background = backgroundAsColour();
    if (m_work.empty())
      return drawing;
    layOut();
    tell(0.3, "finding lines");
    parallelFor(m_work.size(), 1, [&](std::size_t i) { findLines(m_work[i], *m_view, m_light); });
    tell(0.5, "finding what hides what");
    std::vector<DepthLayer> layers(m_work.size());
    const LayerInput input{*m_view, m_settings.environment.background, m_keyLight, pixelsPerTone()};
    parallelFor(m_work.size(), 1, [&](std::size_t i) {
      layers[i] = depthLayer(m_work[i].shown, input, m_work[i].area);
    });
    tell(0.7, "setting strokes");
    m_depths.resize(layers.size());
    parallelFor(layers.size(), 1, [&](std::size_t i) { m_depths[i] = meanDepth(layers[i]); });
    const LayerStack stack(layers, m_view->size());
    m_ranks = paintRanks(stack, m_depths);
    m_tones.resize(layers.size());
    parallelFor(layers.size(), 1, [&](std::size_t i) {
      if (layers[i].filled())
        m_tones[i] = seenTones({layers[i], i, m_ranks}, stack);
    });
    std::vector<VectorStructure> structures(m_work.size());
    parallelFor(m_work.size(), 1,
                [&](std::size_t i) { structures[i] = drawnLines(m_work[i], layers, i, stack); });
    addFills(layers, stack, structures);
    std::erase_if(structures,
                  [](const VectorStructure& s) { return !s.filled() && s.lines.empty(); });
    std::stable_sort(structures.begin(), structures.end(),
                     [](const VectorStructure& a, const VectorStructure& b) {
                       return a.paintRank < b.paintRank;
                     });
    drawing.structures = std::move(structures);
    return drawing;
  }

 private:
  void tell(double share, std::string_view what) const {
    if (m_progress)
      m_progress(share, what);
  }

  Colour backgroundAsColour() const {
    const glm::vec4 c = 255.0f * backgroundColour(m_settings.environment.background);
    return {std::uint8_t(std::lround(c.r)), std::uint8_t(std::lround(c.g)),
            std::uint8_t(std::lround(c.b))};
  }

  /// Returns the pixels per tone. The more structures are shaded, the fewer tones each has, to keep
  /// files small.
  double pixelsPerTone() const {
    const auto shaded = std::count_if(m_work.begin(), m_work.end(), [](const StructureWork& work) {
      return transitions(gammaSpan(work.shown.style).most).shading > 0.0f;
    });
    return std::clamp(double(shaded) / 9.0, 3.0, 9.0);
  }

  void findShown() {
    m_work = structureWork(m_scene, m_surfaces);
    for (const StructureWork& work : m_work)
      m_bounds.add(work.shown.mesh->bounds());
  }

  /// Chooses the size of pixels so that all layers fit into memory.
  void layOut() {
    float height = standardHeight;
    for (int round = 0; round < 2; ++round) {
      const PixelSize size = pixelSize(m_settings.sizeMm, height);
      m_view.emplace(m_camera, m_bounds, size.width, size.height);
      double pixels = 0.0;
      findAreas(m_work, *m_view);
      for (const StructureWork& work : m_work)
        pixels += double(work.area.width) * double(work.area.height);
      if (pixels <= mostLayerPixels)
        break;
      height = float(size.height) * float(std::sqrt(0.95 * mostLayerPixels / pixels));
    }
    std::erase_if(m_work, [](const StructureWork& work) { return work.area.empty(); });
    const model::KeyLight own = m_scene.keyLight().value_or(model::KeyLight());
    m_light = m_settings.environment.light.value_or(own.towards);
    if (m_settings.environment.keyLight.value_or(own.shades))
      m_keyLight = m_view->toPatient(m_light);
    m_page = {.mmPerPixel = m_settings.sizeMm.y / m_view->size().y,
              .heightMm = m_settings.sizeMm.y};
    prepareLines(m_work);
  }

  void addFills(std::span<const DepthLayer> layers, const LayerStack& stack,
                std::span<VectorStructure> structures) {
    const std::vector<ToneImage> images = toneImages(stack, layers, m_tones, m_ranks);
    for (std::size_t i = 0; i < images.size(); ++i)
      if (!images[i].area.empty())
        joinTones(m_tones[i], m_tones[i].firstCapTone);
    joinTonesWithin(m_tones, fillOutline(structures));
    parallelFor(m_work.size(), 1, [&](std::size_t i) {
      FillShapes fills = fillShapes(m_tones[i], images[i], m_page);
      structures[i].tones = std::move(fills.tones);
      structures[i].fills = std::move(fills.shapes);
      structures[i].fillOpacity = fills.opacity;
    });
  }

  /// Returns how long outlines of fills may be in total, in addition to these lines; pixels.
  double fillOutline(std::span<const VectorStructure> structures) const {
    std::size_t pieces = 0;
    for (const VectorStructure& structure : structures)
      for (const VectorLines& lines : structure.lines)
        for (const VectorShape& shape : lines.shapes)
          for (const Curve& curve : shape.path)
            pieces += curve.pieces.size();
    const double left = std::max(mostBytes - bytesPerPiece * double(pieces), leastFillBytes);
    return left / bytesPerOutline * double(m_view->outputUnit());
  }

  VectorStructure drawnLines(StructureWork& work, std::span<const DepthLayer> layers,
                             std::size_t index, const LayerStack& stack) const {
    VectorStructure structure;
    structure.id = work.shown.id;
    structure.depth = m_depths[index];
    structure.paintRank = m_ranks[index];
    if (!work.hasLines())
      return structure;
    const model::ResolvedStyle& style = work.shown.style;
    structure.grain = style.grain;
    const Colour colour = inkColour(style, m_settings.environment.background);
    addHidden(work, layers, index, stack, structure);
    for (const LineLayer& layer : takeLayers(work)) {
      const StrokeScene scene{.stack = stack,
                              .own = layers[index],
                              .ownIndex = index,
                              .projection = m_view->depthTerms(),
                              .probes = contourProbes(work.shown.surface(), *m_view, style),
                              .ink = layer.opacity};
      PenShapes pen(m_page, vectorTolerance * m_view->outputUnit());
      for (const VisibleStroke& stroke : seenLines(work, layer.lines, scene, *m_view))
        pen.add(stroke, colour);
      if (std::vector<VectorShape> shapes = pen.take(); !shapes.empty())
        structure.lines.push_back({layer.kind, layer.opacity, false, std::move(shapes)});
    }
    return structure;
  }

  /// Adds the parts of the outlines that other structures hide, where the style wants them.
  void addHidden(const StructureWork& work, std::span<const DepthLayer> layers, std::size_t index,
                 const LayerStack& stack, VectorStructure& structure) const {
    const model::ResolvedStyle& style = work.shown.style;
    const model::Surface& surface = work.shown.surface();
    const std::vector<Stroke> found = hiddenStrokes(surface, *m_view, style, work.lines, work.area);
    if (found.empty())
      return;
    const float ink = evenInk(style);
    const StrokeScene scene{.stack = stack,
                            .own = layers[index],
                            .ownIndex = index,
                            .projection = m_view->depthTerms(),
                            .probes = contourProbes(surface, *m_view, style),
                            .hidden = true,
                            .ink = ink};
    PenShapes pen(m_page, vectorTolerance * m_view->outputUnit());
    for (const InkChain& chain : inkChains(found))
      for (const VisibleStroke& stroke : withinPage(visibleStrokes(chain, scene), m_view->size()))
        pen.add(stroke, inkColour(style, m_settings.environment.background));
    if (std::vector<VectorShape> shapes = pen.take(); !shapes.empty())
      structure.lines.push_back(
          {"Hidden outlines", rule::hiddenShare * ink, true, std::move(shapes)});
  }

  const model::Scene& m_scene;
  const model::Camera& m_camera;
  const VectorSettings& m_settings;
  const VectorProgress& m_progress;
  KeptSurfaces m_surfaces;
  std::vector<StructureWork> m_work;
  model::Box m_bounds;
  std::optional<PictureView> m_view;
  PageMapping m_page;
  std::vector<float> m_depths;       ///< one per layer
  std::vector<std::size_t> m_ranks;  ///< see FilledLayer
  std::vector<SeenTones> m_tones;    ///< one per layer
  glm::vec3 m_light{0.0f};
  glm::vec3 m_keyLight{0.0f};  ///< patient frame; 0: there is none
};

}  // namespace

Result<VectorDrawing> drawVectors(const model::Scene& scene, const model::Camera& camera,
                                  const VectorSettings& settings, const VectorProgress& progress) {
  for (const float side : {settings.sizeMm.x, settings.sizeMm.y})
    if (!pageLimitsMm.contain(side))
      return Error{
          .reason = "a page with a side of " + std::to_string(side) + " mm cannot be drawn",
          .remedy = "Ask for 10 to 5000 mm each way"};
  if (const auto fault = model::cameraFault(camera))
    return Error{.where = "camera", .reason = std::string(*fault), .remedy = "Correct the camera"};
  return Drawing(scene, camera, settings, progress).make();
}

}  // namespace sline::render
