// SPDX-License-Identifier: Apache-2.0
// Draws lines around structures over a picture that is done, without drawing any layer anew.
#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>

#include "model/base/parallel.h"
#include "render/picture/layer_content.h"
#include "render/picture/layer_painter.h"
#include "render/software/surface_raster.h"
#include "render/strokes/section_caps.h"

namespace sline::render {

namespace {

/// Returns the number, 1 … 255, of the structure at that place of the list.
int numberAt(std::size_t place) {
  return int(place % 255) + 1;
}

/// Returns the fill that marks a surface with its number.
SurfaceFill numberFill(std::size_t place) {
  return {.kind = SurfaceFill::Kind::flat,
          .wash = glm::vec4(float(numberAt(place)) / 255.0f, 0.0f, 0.0f, 1.0f)};
}

std::vector<PreparedStructure> outlined(const PictureInput& input, const Outline& outline) {
  std::vector<PreparedStructure> structures;
  for (const PreparedStructure& shown : input.shown)
    if (std::binary_search(outline.structures.begin(), outline.structures.end(), shown.id))
      structures.push_back(shown);
  return structures;
}

/// Returns the layers that may hide what is outlined. In place of its ink each has the number of
/// the only structure in it, which does not hide itself, or 0.
std::vector<ListedLayer> hidingLayers(std::span<const Layer> kept, std::span<const Layer> outlined,
                                      const PixelRect& region, Background background) {
  std::map<model::NodeId, int> numbers;
  for (const Layer& layer : outlined)
    for (const PreparedStructure& member : layer.members)
      numbers.emplace(member.id, numberAt(numbers.size()));
  std::vector<ListedLayer> hiding;
  for (const Layer& layer : kept)
    for (ListedLayer& listed : listedLayers({&layer, 1}, region, background)) {
      const auto own = numbers.find(layer.members.front().id);
      const bool known = layer.members.size() == 1 && own != numbers.end();
      listed.layer.ink = {0, 0, std::uint8_t(known ? own->second : 0)};
      hiding.push_back(listed);
    }
  return hiding;
}

/// Draws the numbers on the processor. Returns false where a driver must.
bool rasteriseNumbers(const PictureInput& input, std::span<const Layer> layers,
                      const PixelRect& region, const PictureCanvas& numbers) {
  std::vector<RasterMember> members;
  std::vector<PixelRect> rectangles;
  for (const Layer& layer : layers) {
    for (const PreparedStructure& shown : layer.members) {
      if (shown.cut)
        return false;
      members.push_back({shown, numberFill(members.size()), shown.surface().clusters});
    }
    PixelRect seen = intersection(layer.area, region);
    seen.x -= region.x;
    seen.y -= region.y;
    rectangles.push_back(seen);
  }
  TileMask squares(region);
  squares.markAll();
  const std::size_t count = std::size_t(region.width) * std::size_t(region.height);
  std::vector<float> depths(count, 1.0f);
  std::vector<std::uint32_t> colours(count);
  if (!rasterise(members,
                 {.view = input.view,
                  .squares = squares,
                  .samples = {{}, region},
                  .rectangles = rectangles},
                 {depths, colours}))
    return false;
  const PixelRect all{0, 0, region.width, region.height};
  numbers.colour->upload(std::as_bytes(std::span(colours)), all);
  numbers.depth->upload(std::as_bytes(std::span(depths)), all);
  return true;
}

}  // namespace

void LayerPainter::drawNumbers(gpu::Device& device, const PictureInput& input,
                               std::span<Layer> layers, const PixelRect& region) const {
  const passes::SurfaceView view{.viewProjection = input.view.viewProjection(),
                                 .eye = input.view.eyeVector(),
                                 .pictureSize = input.view.size()};
  parallelFor(layers.size(), 1, [&](std::size_t i) {
    layers[i].touched = TileMask(region, layers[i].area);
    layers[i].touched.markAll();
    findTriangles(layers[i], input.view, region);
  });
  const gpu::Target& target = *m_numbers.target;
  device.clear(target, {.colour = glm::vec4(0.0f), .depth = 1.0f});
  gpu::DrawQueue queue(device.software());
  std::size_t place = 0;
  for (const Layer& layer : layers)
    for (std::size_t i = 0; i < layer.members.size(); ++i, ++place) {
      const PreparedStructure& shown = layer.members[i];
      const SurfaceFill fill = numberFill(place);
      const PixelRect slot{layer.area.x - region.x, layer.area.y - region.y, layer.area.width,
                           layer.area.height};
      drawMember(device, {target, layer, i, {layer.area, slot}, fill}, view, queue);
      if (!hasCaps(shown))
        continue;
      const CapDraws caps = capDraws(shown, input.view, input.background, layer.area, slot);
      for (passes::CapDraw draw : caps.draws) {
        draw.colour = fill.wash;
        draw.strokeColour = glm::vec4(0.0f);
        m_capPass->draw(device, target, draw);
      }
    }
}

Status LayerPainter::outline(gpu::Device& device, const PictureInput& input,
                             const PixelRect& region, const gpu::Target& target,
                             const Outline& outline) {
  const std::vector<PreparedStructure> structures = outlined(input, outline);
  std::vector<Layer> layers = planLayers(structures, input.view, region, input.parts);
  if (layers.empty())
    return Unit{};
  std::vector<std::size_t> all(layers.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  completeSurfaces(input, layers, all);
  if (Status s = upload(device, m_kept); !s)
    return s;
  if (Status s = m_numbers.resize({region.width, region.height}, true); !s)
    return s;
  if (!input.processor || !rasteriseNumbers(input, layers, region, m_numbers))
    drawNumbers(device, input, layers, region);

  const float half = 0.5f * outline.width;
  const float casing = half + outline.casingWidth;
  TileMask wanted(region);
  for (const Layer& layer : layers)
    wanted.mark(grown(layer.area, passes::ResolvePass::outlineReach(casing)));
  const TileLists lists = tileLists(hidingLayers(m_kept, layers, region, input.background), wanted);
  m_resolvePass->upload(lists.tiles, lists.entries);
  m_resolvePass->drawOutlines(device, target,
                              {.numbers = *m_numbers.colour,
                               .numberDepths = *m_numbers.depth,
                               .colours = m_atlas.colours(),
                               .depths = m_atlas.layerDepths(),
                               .region = region,
                               .ink = rgb(outline.ink),
                               .casing = rgb(outline.casing),
                               .halfWidth = half,
                               .casingHalfWidth = casing,
                               .strength = outline.strength,
                               .hiddenStrength = 0.35f * outline.strength});
  return Unit{};
}

}  // namespace sline::render
