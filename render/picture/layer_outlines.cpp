// SPDX-License-Identifier: Apache-2.0
// Draws lines around structures over a picture that is done, without drawing any layer anew.
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "model/base/parallel.h"
#include "render/drawn/section_caps.h"
#include "render/picture/layer_content.h"
#include "render/picture/layer_painter.h"

namespace sline::render {

namespace {

std::vector<PreparedStructure> outlined(const PictureInput& input, const Outline& outline) {
  std::vector<PreparedStructure> structures;
  for (const PreparedStructure& shown : input.shown)
    if (std::binary_search(outline.structures.begin(), outline.structures.end(), shown.id))
      structures.push_back(shown);
  return structures;
}

/// Returns the layers that may hide what is outlined, with their numbers in place of their ink.
std::vector<ListedLayer> hidingLayers(std::span<const Layer> kept, const OutlinedNumbers& numbers,
                                      const PixelRect& region, Background background) {
  std::vector<ListedLayer> hiding;
  for (const Layer& layer : kept)
    for (ListedLayer& listed : listedLayers({&layer, 1}, region, background)) {
      listed.layer.ink = {0, 0, std::uint8_t(numbers.of(layer))};
      hiding.push_back(listed);
    }
  return hiding;
}

}  // namespace

void LayerPainter::drawNumbers(gpu::Device& device, const PictureInput& input,
                               std::span<Layer> layers, const OutlinedNumbers& numbers,
                               const PixelRect& region) const {
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
  for (const Layer& layer : layers)
    for (std::size_t i = 0; i < layer.members.size(); ++i) {
      const PreparedStructure& shown = layer.members[i];
      const SurfaceFill fill = numberFill(numbers.of(shown.id));
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

std::optional<ProcessorOutlines::Drawn> LayerPainter::outline(const PictureInput& input,
                                                              const PixelRect& region,
                                                              const Outline& outline) {
  if (!m_blended)
    return std::nullopt;
  const std::vector<PreparedStructure> structures = outlined(input, outline);
  const auto drawn = m_outlines.draw(input, structures, m_kept, region, lookOf(outline));
  return drawn.ink ? std::optional(drawn) : std::nullopt;
}

Status LayerPainter::lay(gpu::Device& device, const ProcessorOutlines::Drawn& drawn,
                         const OutlinePlace& place) {
  if (drawn.ink->rectangles.empty())
    return Unit{};
  // As large as the region, so that it serves the next area as well.
  const PixelRect& area = drawn.area;
  TRY(m_numbers.resize({place.region.width, place.region.height}, false));
  TRY(m_numbers.colour->upload(std::as_bytes(std::span(drawn.ink->colours)),
                               {0, 0, area.width, area.height}));
  m_overlayPass->draw(device, place.target,
                      {*m_numbers.colour, {area.x, area.y}, drawn.ink->rectangles});
  return Unit{};
}

Status LayerPainter::outline(gpu::Device& device, const PictureInput& input,
                             const OutlinePlace& place, const Outline& outline) {
  const PixelRect& region = place.region;
  if (const auto drawn = this->outline(input, region, outline))
    return lay(device, *drawn, place);
  const std::vector<PreparedStructure> structures = outlined(input, outline);
  std::vector<Layer> layers = planLayers(structures, input.view, region, input.parts);
  if (layers.empty())
    return Unit{};
  const OutlineLook look = lookOf(outline);
  std::vector<std::size_t> all(layers.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  completeSurfaces(input, layers, all);
  TRY(upload(device, m_kept));
  TRY(m_numbers.resize({region.width, region.height}, true));
  const OutlinedNumbers numbers(structures);
  drawNumbers(device, input, layers, numbers, region);

  TileMask wanted(region);
  for (const Layer& layer : layers)
    wanted.mark(grown(layer.area, look.reach()));
  const TileLists lists =
      tileLists(hidingLayers(m_kept, numbers, region, input.background), wanted);
  TRY(m_resolvePass->upload(lists.tiles, lists.entries));
  m_resolvePass->drawOutlines(device, place.target,
                              {.numbers = *m_numbers.colour,
                               .numberDepths = *m_numbers.depth,
                               .colours = m_atlas.colours(),
                               .depths = m_atlas.layerDepths(),
                               .region = region,
                               .look = look});
  return Unit{};
}

}  // namespace sline::render
