// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/hidden_lines.h"

#include <algorithm>
#include <cmath>

#include "render/lines/chains.h"
#include "render/lines/line_technique.h"
#include "render/lines/stages.h"
#include "render/strokes/stroke_maker.h"

namespace sline::render {

namespace {

constexpr float dashLength = 6.0f;  // λ
constexpr float dashGap = 4.0f;     // λ
// Thinner hidden outlines could hardly be seen at half strength.
constexpr float leastHidden = 1.3f;  // λ

std::vector<Stroke> besideOutlines(const model::Surface& surface, const PictureView& view,
                                   const std::vector<Segment>& segments, const PixelRect& area,
                                   float width) {
  StrokeMaker maker(surface, view, area);
  for (const Segment& s : segments)
    maker.contour(s, width, 1.0f, 1.0f);
  return maker.take();
}

const std::vector<Segment>& outlinesOf(const StructureLines& drawn) {
  return drawn.lines[LineKind::contour];
}

}  // namespace

std::vector<Segment> dashed(const std::vector<Segment>& segments, const PictureView& view) {
  const Chains chains = connectedChains(segments);
  const float period = (dashLength + dashGap) * view.outputUnit();
  std::vector<Segment> dashes;
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    const std::uint32_t first = chains.first[chain];
    const std::uint32_t last = chains.first[chain + 1];
    std::vector<float> way{0.0f};
    float highest = -std::numeric_limits<float>::infinity();
    float anchor = 0.0f;
    for (std::uint32_t i = first; i < last; ++i) {
      const Segment& s = segments[chains.links[i].segment];
      const float length =
          glm::distance(view.project(s.a + s.moveA).pixel, view.project(s.b + s.moveB).pixel);
      if (const float z = std::max(s.a.z, s.b.z); z > highest) {
        highest = z;
        anchor = way.back();
      }
      way.push_back(way.back() + length);
    }
    // The middle of a dash lies at the anchor.
    for (std::uint32_t i = first; i < last; ++i) {
      const float at = 0.5f * (way[i - first] + way[i - first + 1]) - anchor;
      const float phase = at / period - std::floor(at / period + 0.5f);
      if (std::abs(phase) <= 0.5f * dashLength / (dashLength + dashGap))
        dashes.push_back(segments[chains.links[i].segment]);
    }
  }
  return dashes;
}

std::vector<Stroke> hiddenStrokes(const model::Surface& surface, const PictureView& view,
                                  const model::ResolvedStyle& style, const StructureLines& drawn,
                                  const PixelRect& area) {
  if (style.hiddenLines == model::HiddenLines::none || !showsLines(style))
    return {};
  const float pen = penWidth(surface, view, style.penWeight) * transitions(style.gamma).lines;
  return besideOutlines(
      surface, view,
      style.hiddenLines == model::HiddenLines::dashed ? drawn.dashes : outlinesOf(drawn), area,
      std::min(pen, std::max(hiddenWidth * pen, leastHidden * view.outputUnit())));
}

float haloWidth(const model::Surface& surface, const PictureView& view,
                const model::ResolvedStyle& style) {
  if (!(style.halo > 0.0f) || !showsLines(style))
    return 0.0f;
  return (1.0f + style.halo) * penWidth(surface, view, style.penWeight);
}

std::vector<Stroke> haloStrokes(const model::Surface& surface, const PictureView& view,
                                const model::ResolvedStyle& style, const StructureLines& drawn,
                                const PixelRect& area) {
  const float width = haloWidth(surface, view, style);
  if (!(width > 0.0f))
    return {};
  std::vector<Segment> even = outlinesOf(drawn);
  // They begin beside the pen's own ink, which hidden outlines may need.
  const float pen = width / (1.0f + style.halo);
  for (Segment& s : even) {
    s.pressureA = s.pressureB = 1.0f;
    s.moveA += pen * view.millimetresPerPixel(s.a) * s.normalA;
    s.moveB += pen * view.millimetresPerPixel(s.b) * s.normalB;
  }
  return besideOutlines(surface, view, even, area, width - pen);
}

}  // namespace sline::render
