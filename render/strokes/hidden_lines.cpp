// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/hidden_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/lines/ground/chains.h"
#include "render/lines/techniques/line_technique.h"
#include "render/strokes/stroke_maker.h"

namespace sline::render {

namespace {

constexpr float dashLength = 6.0f;  // λ
constexpr float dashGap = 4.0f;     // λ
// Dashes are anchored where a line crosses heights about this far apart, λ, and agree over about
// this way.
constexpr float voteSpacing = 40.0f;
constexpr float voteReach = 20.0f;
// How much a line's highest point counts: little, as another point may become the highest at once.
constexpr float topWeight = 0.02f;
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

/// Returns the segments with what Γ leaves of each, where it varies.
std::vector<Segment> left(const std::vector<Segment>& segments, const model::ResolvedStyle& style) {
  std::vector<Segment> some = segments;
  if (gammaVaries(style))
    std::transform(some.begin(), some.end(), some.begin(), leaving);
  return some;
}

const std::vector<Segment>& outlinesOf(const StructureLines& drawn) {
  return drawn.lines[LineKind::contour];
}

/// One line that is to be dashed; lengths are along its curve in the picture, px.
struct DashedLine {
  std::vector<float> ends{0.0f};  ///< of the segments, from the line's beginning
  std::vector<float> heights;     ///< along the picture's vertical at the same points, mm
  bool closed = false;

  float length() const { return ends.back(); }
  /// Returns the signed way from one place to another, on a ring the shorter one.
  float way(float from, float to) const {
    const float d = to - from;
    return closed ? d - length() * std::round(d / length()) : d;
  }
};

/// A place where the middle of a dash should lie.
struct DashVote {
  float at;  ///< px along the line
  float weight;
};

/// Returns where the line crosses heights that stay while the scene turns, and its highest point.
/// A line that only touches such a height begins to cross it without any weight, so that no vote
/// comes or goes at once.
std::vector<DashVote> votesOf(const DashedLine& line, float spacing, float mmPerPixel) {
  const std::size_t top = std::size_t(std::max_element(line.heights.begin(), line.heights.end()) -
                                      line.heights.begin());
  std::vector<DashVote> votes{{line.ends[top], topWeight}};
  for (std::size_t i = 0; i + 1 < line.heights.size(); ++i) {
    const float a = line.heights[i] / spacing;
    const float b = line.heights[i + 1] / spacing;
    const float length = (line.ends[i + 1] - line.ends[i]) * mmPerPixel;
    if (a == b || !(length > 0.0f))
      continue;
    const float steep = std::min((b - a) * spacing / length, 1.0f);
    for (float k = std::ceil(std::min(a, b)); k < std::max(a, b); k += 1.0f)
      votes.push_back({glm::mix(line.ends[i], line.ends[i + 1], (k - a) / (b - a)), steep * steep});
  }
  return votes;
}

/// Tells whether a place of the line is drawn, as the votes around it agree: e^(iΦ), Φ the phase
/// of the dashes, is the mean of what each says, by a Gaussian's weights. Where neighbours do not
/// agree on a whole number of dashes between them, these become a little longer or shorter.
bool inDash(const DashedLine& line, const std::vector<DashVote>& votes, float at, float unit) {
  const float period = (dashLength + dashGap) * unit;
  float nearest = std::numeric_limits<float>::infinity();
  for (const DashVote& vote : votes)
    nearest = std::min(nearest, std::abs(line.way(vote.at, at)));
  const float deviation = voteReach * unit;
  float cosine = 0.0f;
  float sine = 0.0f;
  for (const DashVote& vote : votes) {
    const float way = line.way(vote.at, at);
    const float share = 0.5f * (way * way - nearest * nearest) / (deviation * deviation);
    if (share > 16.0f)
      continue;
    const float weight = vote.weight * std::exp(-share);
    const float angle = 6.2831853f * way / period;
    cosine += weight * std::cos(angle);
    sine += weight * std::sin(angle);
  }
  return std::abs(std::atan2(sine, cosine)) <= 3.1415927f * dashLength / (dashLength + dashGap);
}

}  // namespace

std::vector<Segment> dashed(const std::vector<Segment>& segments, const PictureView& view) {
  const Chains chains = connectedChains(segments);
  const float unit = view.outputUnit();
  const float mmPerPixel = view.millimetresPerPixel(view.bounds().centre());
  const glm::vec3 up = view.toPatient({0.0f, 1.0f, 0.0f});
  // Powers of two, so that they stay where they are while one comes a little nearer.
  const float spacing =
      std::exp2(std::round(std::log2(std::max(voteSpacing * unit * mmPerPixel, 1e-6f))));
  std::vector<Segment> dashes;
  for (std::size_t chain = 0; chain < chains.count(); ++chain) {
    const std::uint32_t first = chains.first[chain];
    const std::uint32_t last = chains.first[chain + 1];
    DashedLine line;
    const auto place = [&](std::uint32_t i, bool atEnd) -> const glm::vec3& {
      const Segment& s = segments[chains.links[i].segment];
      return atEnd != chains.links[i].reversed ? s.b : s.a;
    };
    line.heights.push_back(glm::dot(place(first, false), up));
    for (std::uint32_t i = first; i < last; ++i) {
      const Segment& s = segments[chains.links[i].segment];
      line.ends.push_back(line.length() + glm::distance(view.project(s.a + s.moveA).pixel,
                                                        view.project(s.b + s.moveB).pixel));
      line.heights.push_back(glm::dot(place(i, true), up));
    }
    line.closed = last - first > 2 && place(first, false) == place(last - 1, true);
    if (!(line.length() > 0.0f))
      continue;
    const std::vector<DashVote> votes = votesOf(line, spacing, mmPerPixel);
    for (std::uint32_t i = first; i < last; ++i)
      if (inDash(line, votes, 0.5f * (line.ends[i - first] + line.ends[i - first + 1]), unit))
        dashes.push_back(segments[chains.links[i].segment]);
  }
  return dashes;
}

std::vector<Stroke> hiddenStrokes(const model::Surface& surface, const PictureView& view,
                                  const model::ResolvedStyle& style, const StructureLines& drawn,
                                  const PixelRect& area) {
  if (style.hiddenLines == model::HiddenLines::none || !showsLines(style))
    return {};
  const float pen = penWidth(surface, view, style.penWeight) * evenInk(style);
  return besideOutlines(
      surface, view,
      left(style.hiddenLines == model::HiddenLines::dashed ? drawn.dashes : outlinesOf(drawn),
           style),
      area, std::min(pen, std::max(hiddenWidth * pen, leastHidden * view.outputUnit())));
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
  std::vector<Segment> even = left(outlinesOf(drawn), style);
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
