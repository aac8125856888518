// SPDX-License-Identifier: Apache-2.0
#include "render/picture/processor_drawing.h"

#include "render/picture/layer_content.h"
#include "render/picture/layer_ink.h"
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

/// Draws the surfaces' depths and fills. Returns false where a driver must.
bool drawSurface(const PictureInput& input, const PixelRect& region, Layer& layer,
                 std::span<const PixelRect> touched) {
  std::vector<RasterMember> members;
  for (const PreparedStructure& shown : layer.members) {
    if (shown.cut || shown.printedHatching)
      return false;
    members.push_back({shown, shownFill(input, shown)});
  }
  LayerPixels& pixels = layer.pixels;
  pixels.area = layer.area;
  pixels.samples = sampledArea(layer, region);
  pixels.filled = layer.filled;
  wipeSurface(pixels, touched);
  const std::vector<PixelRect> squares = sampledSquares(pixels, touched);
  return rasterise(
      members,
      {.view = input.view,
       .squares = layer.touched,
       .samples = pixels.samples,
       .rectangles = squares,
       .key = input.view.toPatient(keyLight(input))},
      {pixels.surfaceDepths, pixels.step() > 1 ? pixels.surfaceColours : pixels.colours});
}

}  // namespace

bool drawOnProcessor(const PictureInput& input, const PixelRect& region, Layer& layer) {
  if (!layer.shows()) {
    layer.onProcessor = input.processor;
    return true;
  }
  if (!input.processor && (layer.filled || layer.members.size() > 1))
    return false;
  const std::vector<PixelRect> touched = layer.touched.rectangles();
  if (!drawSurface(input, region, layer, touched)) {
    layer.pixels = {};
    return false;
  }
  layer.onProcessor = input.processor;
  if (!input.processor)
    return true;
  wipe(layer.pixels, touched);
  const std::vector<PixelRect> shown = layer.mask.rectangles();
  if (layer.filled)
    takeSurface(layer.pixels, shown);
  std::vector<InkDraw> draws = edgeDraws(input, layer);
  const std::vector<InkDraw> strokes = strokeDraws(input, layer);
  draws.insert(draws.end(), strokes.begin(), strokes.end());
  drawInk(layer.pixels, draws);
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
                        .inked = layer.inked,
                        .hiddenInk = layer.hiddenInk,
                        .haloed = layer.haloed});
  return listed;
}

}  // namespace sline::render
