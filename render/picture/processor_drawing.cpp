// SPDX-License-Identifier: Apache-2.0
#include "render/picture/processor_drawing.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "render/picture/layer_content.h"
#include "render/picture/layer_ink.h"
#include "render/software/cap_raster.h"
#include "render/software/ink_raster.h"
#include "render/software/surface_raster.h"

namespace sline::render {

namespace {

/// Returns the squares in samples of the surface, from its area's corner.
std::vector<PixelRect> sampledSquares(const LayerPixels& pixels,
                                      std::span<const PixelRect> squares) {
  // Enlarging looks at one more sample around; there are few, so all are as well.
  if (pixels.step() > 1)
    return {{0, 0, pixels.samples.area.width, pixels.samples.area.height}};
  std::vector<PixelRect> placed(squares.begin(), squares.end());
  for (PixelRect& rect : placed) {
    rect.x -= pixels.area.x;
    rect.y -= pixels.area.y;
  }
  return placed;
}

/// Draws a layer's only member from what is known of its surface, which is found first where it
/// does not serve. Returns false where a driver must.
bool drawKept(const RasterMember& member, const PixelRect& region, const RasterSight& sight,
              Layer& layer, const RasterSurface& surface) {
  SurfaceValues& values = *layer.values;
  if (!values.serves(neededValues(member.fill))) {
    // Another style's lines look at other squares.
    TileMask whole(region, layer.area);
    whole.markAll();
    if (!findValues(member, {sight.view, whole, sight.samples, {}, sight.key}, values))
      return false;
  }
  shadeValues(member.fill, sight, values, surface);
  return true;
}

/// Draws the surfaces' depths and fills. Returns false where a driver must.
bool drawSurface(const PictureInput& input, const PixelRect& region, Layer& layer,
                 std::span<const PixelRect> touched) {
  std::vector<RasterMember> members;
  for (const PreparedStructure& shown : layer.members) {
    if (shown.printedHatching)
      return false;
    const bool coarsely = layer.surfaceStep > 1 && shown.sampled;
    members.push_back(
        {shown, shownFill(input, shown), coarsely ? *shown.sampled : shown.surface().clusters});
  }
  LayerPixels& pixels = layer.pixels;
  pixels.area = layer.area;
  pixels.samples = sampledArea(layer, region);
  pixels.filled = layer.filled;
  wipeSurface(pixels, touched);
  const std::vector<PixelRect> squares = sampledSquares(pixels, touched);
  const RasterSight sight{.view = input.view,
                          .squares = layer.touched,
                          .samples = pixels.samples,
                          .rectangles = squares,
                          .key = input.view.toPatient(keyLight(input))};
  const RasterSurface surface{pixels.surfaceDepths,
                              pixels.step() > 1 ? pixels.surfaceColours : pixels.colours};
  return layer.values ? drawKept(members.front(), region, sight, layer, surface)
                      : rasterise(members, sight, surface);
}

/// Returns the cut faces that are drawn of the layer.
std::vector<RasterCap> capsOf(const PictureInput& input, const Layer& layer) {
  std::vector<RasterCap> caps;
  if (layer.filled)
    for (const PreparedStructure& shown : layer.members)
      if (hasCaps(shown)) {
        std::vector<RasterCap> own = rasterCaps(shown, input.view, input.background);
        std::move(own.begin(), own.end(), std::back_inserter(caps));
      }
  return caps;
}

/// Makes rows of a layer ready for ink: with its surface, and with nothing where that is not.
class RowReadier {
 public:
  RowReadier(Layer& layer, std::span<const PixelRect> touched)
      : m_pixels(layer.pixels), m_touched(touched), m_shown(layer.mask.rectangles()) {
    makeRoom(layer.pixels);
    if (layer.filled)
      m_taker.emplace(layer.pixels);
  }

  void operator()(int first, int end) const {
    const PixelRect rows{m_pixels.area.x, first, m_pixels.area.width, end - first};
    wipe(m_pixels, within(rows, m_touched));
    if (m_taker)
      m_taker->take(within(rows, m_shown));
  }

 private:
  static std::vector<PixelRect> within(const PixelRect& rows, std::span<const PixelRect> of) {
    std::vector<PixelRect> parts;
    for (const PixelRect& rect : of)
      if (const PixelRect part = intersection(rect, rows); !part.empty())
        parts.push_back(part);
    return parts;
  }

  LayerPixels& m_pixels;
  std::span<const PixelRect> m_touched;
  std::vector<PixelRect> m_shown;
  std::optional<SurfaceTaker> m_taker;  ///< where there is a fill
};

/// Makes all rows of a layer ready and draws its cut faces. Where surfaces have a step these are
/// drawn in the picture's own pixels, as they are few and flat, and in samples, which hide lines
/// and from which fills are mended along contours.
void readyWithCaps(const PictureInput& input, LayerPixels& pixels, std::span<const RasterCap> caps,
                   const RowReadier& ready) {
  if (pixels.step() == 1)
    drawCaps(caps, input.view, pixels.samples, {pixels.surfaceDepths, pixels.colours});
  forEachBand(pixels.area, [&](int first, int end) { ready(first, end); });
  if (pixels.step() == 1)
    return;
  drawCaps(caps, input.view, {{}, pixels.area}, {pixels.depths, pixels.colours});
  drawCaps(caps, input.view, pixels.samples, {pixels.surfaceDepths, pixels.surfaceColours});
}

}  // namespace

bool hidesMuch(const PictureInput& input, const PixelRect& region, const Layer& layer) {
  // Smaller layers hide hardly anything, and layers that are drawn in full samples look at theirs
  // only where they show.
  constexpr int share = 64;
  const auto opaque = [](const PreparedStructure& shown) {
    return !shown.printedHatching && !shown.cut && fillCover(shown.style) >= 1.0f;
  };
  return input.processor && layer.surfaceStep > 1 && layer.filled &&
         layer.area.width * layer.area.height > region.width * region.height / share &&
         std::all_of(layer.members.begin(), layer.members.end(), opaque);
}

void sampleSurface(const PictureInput& input, const PixelRect& region, Layer& layer) {
  layer.touched = TileMask(region, layer.area);
  layer.touched.markAll();
  layer.sampled = drawSurface(input, region, layer, {});
}

bool isHidden(const Layer& layer, const Occlusion& occlusion) {
  // Hidden lines are seen through what is in front of them, and halos reach far.
  return std::all_of(layer.members.begin(), layer.members.end(), [&](const auto& shown) {
    return shown.style.hiddenLines == model::HiddenLines::none && !(shown.style.halo > 0.0f) &&
           !shown.printedHatching && occlusion.hides(shown);
  });
}

bool drawOnProcessor(const PictureInput& input, const PixelRect& region, Layer& layer) {
  if (!layer.shows()) {
    layer.pixels.clear();
    layer.onProcessor = input.processor;
    return true;
  }
  if (!input.processor && (input.card || layer.filled || layer.members.size() > 1))
    return false;
  // A driver that has to draw the surface anyway draws its cut faces as well.
  if (!input.processor && layer.members.front().cut)
    return false;
  const std::vector<PixelRect> touched = layer.touched.rectangles();
  const std::vector<RasterCap> caps = capsOf(input, layer);
  if (!areBeforeTheEye(caps, input.view) ||
      (!layer.sampled && !drawSurface(input, region, layer, touched))) {
    layer.pixels = {};
    layer.values.reset();
    return false;
  }
  layer.onProcessor = input.processor;
  if (!input.processor)
    return true;
  const RowReadier ready(layer, touched);
  if (!caps.empty())
    readyWithCaps(input, layer.pixels, caps, ready);
  std::vector<InkDraw> draws = edgeDraws(input, layer);
  const std::vector<InkDraw> strokes = strokeDraws(input, layer);
  draws.insert(draws.end(), strokes.begin(), strokes.end());
  drawInk(layer.pixels, draws, [&](int first, int end) {
    if (caps.empty())
      ready(first, end);
  });
  forgetStrokes(layer);
  return true;
}

std::vector<BlendLayer> blendLayers(std::span<const Layer> layers, Background background) {
  std::vector<BlendLayer> listed;
  for (const Layer& layer : layers)
    if (layer.shows())
      listed.push_back({.pixels = &layer.pixels,
                        .mask = &layer.mask,
                        .ink = inkColour(layer.members.front().style, background),
                        .filled = layer.filled,
                        .inked = layer.inked || layer.haloed,
                        .hiddenInk = layer.hiddenInk,
                        .haloed = layer.haloed});
  return listed;
}

}  // namespace sline::render
