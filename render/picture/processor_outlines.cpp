// SPDX-License-Identifier: Apache-2.0
#include "render/picture/processor_outlines.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "render/drawn/section_caps.h"
#include "render/picture/layer_painter.h"
#include "render/software/cap_raster.h"
#include "render/software/surface_raster.h"
#include "render/strokes/coverage.h"

namespace sline::render {

namespace {

/// Returns the structure's cut faces, marked with the fill's number.
std::vector<RasterCap> markedCaps(const PictureInput& input, const PreparedStructure& shown,
                                  const SurfaceFill& fill) {
  if (!hasCaps(shown))
    return {};
  std::vector<RasterCap> caps = rasterCaps(shown, input.view, input.background);
  for (RasterCap& cap : caps) {
    cap.paint.colour = fill.wash;
    cap.paint.strokeColour = glm::vec4(0.0f);
  }
  return caps;
}

/// Finds where the structures are. Returns nothing where something reaches behind the eye.
std::optional<MarkedPixels> markedPixels(const PictureInput& input,
                                         std::span<const PreparedStructure> structures,
                                         const PixelRect& region, const OutlineLook& look) {
  std::vector<RasterMember> members;
  std::vector<RasterCap> caps;
  PixelRect covered;
  for (const PreparedStructure& shown : structures) {
    const SurfaceFill fill = numberFill(OutlinedNumbers::at(members.size()));
    const bool coarsely = input.surfaceStep > 1 && shown.sampled;
    members.push_back({shown, fill, coarsely ? *shown.sampled : shown.surface().clusters});
    covered = united(covered, coveredArea(shown, input.view, region));
    for (RasterCap& cap : markedCaps(input, shown, fill))
      caps.push_back(std::move(cap));
  }
  MarkedPixels marks{.area = markedArea(covered, region, look), .numbers = {}, .depths = {}};
  const std::size_t count = std::size_t(marks.area.width) * std::size_t(marks.area.height);
  const PixelRect all{0, 0, marks.area.width, marks.area.height};
  const SampleArea samples{{}, marks.area};
  TileMask squares(region, marks.area);
  squares.markAll();
  marks.depths.assign(count, 1.0f);
  std::vector<std::uint32_t> colours(count);
  if (!areBeforeTheEye(caps, input.view) ||
      !rasterise(
          members,
          {.view = input.view, .squares = squares, .samples = samples, .rectangles = {&all, 1}},
          {marks.depths, colours}))
    return std::nullopt;
  drawCaps(caps, input.view, samples, {marks.depths, colours});
  marks.numbers.resize(count);
  std::transform(colours.begin(), colours.end(), marks.numbers.begin(),
                 [](std::uint32_t colour) { return std::uint8_t(colour & 0xffU); });
  return marks;
}

}  // namespace

OutlineLook lookOf(const Outline& outline) {
  const float half = 0.5f * outline.width;
  return {.ink = rgb(outline.ink),
          .casing = rgb(outline.casing),
          .halfWidth = half,
          .casingHalfWidth = half + outline.casingWidth,
          .strength = outline.strength,
          .hiddenStrength = 0.35f * outline.strength};
}

OutlinedNumbers::OutlinedNumbers(std::span<const PreparedStructure> outlined) {
  for (const PreparedStructure& shown : outlined)
    m_numbers.emplace(shown.id, at(m_numbers.size()));
}

int OutlinedNumbers::of(model::NodeId id) const {
  const auto own = m_numbers.find(id);
  return own == m_numbers.end() ? 0 : own->second;
}

int OutlinedNumbers::of(const Layer& layer) const {
  return layer.members.size() == 1 ? of(layer.members.front().id) : 0;
}

SurfaceFill numberFill(int number) {
  return {.kind = SurfaceFill::Kind::flat,
          .wash = glm::vec4(float(number) / 255.0f, 0.0f, 0.0f, 1.0f)};
}

ProcessorOutlines::Kept& ProcessorOutlines::marked(const PictureInput& input,
                                                   std::span<const PreparedStructure> structures,
                                                   const PixelRect& region,
                                                   const OutlineLook& look) {
  const auto liesAlike = [](const PreparedStructure& a, const PreparedStructure& b) {
    return a.sharesSurface(b) && hasCaps(a) == hasCaps(b);
  };
  const auto same = std::find_if(m_kept.begin(), m_kept.end(), [&](const Kept& kept) {
    return kept.look == look && std::equal(kept.structures.begin(), kept.structures.end(),
                                           structures.begin(), structures.end(), liesAlike);
  });
  if (same != m_kept.end())
    return *same;
  Kept& kept = m_kept.emplace_back();
  kept.structures.assign(structures.begin(), structures.end());
  kept.look = look;
  if (std::optional<MarkedPixels> marks = markedPixels(input, structures, region, look)) {
    kept.known = true;
    kept.marks = std::move(*marks);
  }
  return kept;
}

ProcessorOutlines::Drawn ProcessorOutlines::draw(const PictureInput& input,
                                                 std::span<const PreparedStructure> structures,
                                                 std::span<const Layer> layers,
                                                 const PixelRect& region, const OutlineLook& look) {
  Kept& kept = marked(input, structures, region, look);
  kept.used = true;
  if (!kept.known)
    return {};
  const OutlinedNumbers numbers(structures);
  std::vector<HidingLayer> hiding;
  std::vector<std::uint64_t> drawings;
  for (const Layer& layer : layers) {
    // A structure alone does not hide itself.
    const int own = numbers.of(layer);
    if (!layer.shows() || !layer.filled || (own > 0 && structures.size() == 1))
      continue;
    hiding.push_back({&layer.pixels, &layer.mask, own});
    drawings.push_back(layer.drawing);
  }
  if (kept.ink.colours.empty() || kept.hiding != drawings) {
    kept.ink = outlineInk(kept.marks, region, hiding, look);
    kept.hiding = std::move(drawings);
  }
  return {kept.marks.area, &kept.ink};
}

void ProcessorOutlines::next() {
  std::erase_if(m_kept, [](const Kept& kept) { return !kept.used; });
  for (Kept& kept : m_kept)
    kept.used = false;
}

}  // namespace sline::render
