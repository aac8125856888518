// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/visible_strokes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "render/sight/contour_look.h"

namespace sline::render {

namespace {

// Pixels. A pen would not lift for a gap this short, nor draw a mark this short.
constexpr std::size_t shortestGap = 3;
constexpr std::size_t shortestMark = 3;
// Pixels, and the largest difference of a channel: a line behind fills changes its colour no
// sooner.
constexpr std::size_t shortestShade = 8;
// Pixels over which a line must run under an outline so that it is left out there; where the two
// cross, the order of painting serves.
constexpr std::size_t longestCrossing = 12;
constexpr float sameShade = 0.08f;
// Fills in front of a line leave one of this many grades of it.
constexpr int veilGrades = 8;
// Pixels of half a width; thinner ink is not worth drawing.
constexpr float thinnest = 0.06f;

struct Sample {
  StrokePoint point;
  Veil veil;
  int grade = 0;       ///< 0 hidden … veilGrades whole
  bool inked = false;  ///< a nearer structure's outline lies over it
};

class StrokeSampler {
 public:
  explicit StrokeSampler(const StrokeScene& scene) : m_scene(scene) {}

  Sample sampleAt(const Stroke& s, float t) const {
    const glm::vec2 on = glm::mix(s.a, s.b, t);
    const float depth = glm::mix(s.depthA, s.depthB, t);
    float halfWidth = glm::mix(s.halfWidthA, s.halfWidthB, t) *
                      std::min(glm::mix(s.opacityA, s.opacityB, t) / m_scene.ink, 1.0f);
    Sample sample;
    const glm::vec2 move = glm::mix(s.moveA, s.moveB, t);
    sample.point.at = on + move;
    sample.point.depth = depth;
    float seenAt = depth;
    if (s.kind == StrokeKind::contour) {
      const glm::vec2 outward = outwardAt(s, t);
      const std::optional<int> look = lookFor(on, depth, s.tolerance, outward);
      if (!look)
        return sample;
      const float left = s.innerShare;
      if (left < 1.0f &&
          depthAt(on + rule::probeOutside(*look, m_scene.probes.probe, m_scene.probes.reach) *
                           outward) < 1.0f)
        halfWidth *= left;
      sample.point.at = on + move + rule::penOutside(halfWidth) * outward;
      seenAt = lifted(depth, 2.0f * s.tolerance);
    } else if (!surfaceLineVisible(on, depth, s.tolerance)) {
      return sample;
    }
    sample.point.halfWidth = halfWidth;
    if (halfWidth < thinnest)
      return sample;
    sample.veil = m_scene.stack.before(sample.point.at, seenAt, m_scene.ownIndex);
    sample.grade = int(std::lround(sample.veil.transmittance * float(veilGrades)));
    if (m_scene.hidden) {
      sample.grade = 2 * sample.grade < veilGrades ? veilGrades : 0;
      sample.veil = {};
    } else if (m_scene.stack.haloed(on, seenAt, m_scene.ownIndex)) {
      sample.grade = 0;
    } else {
      sample.inked = m_scene.stack.inked(sample.point.at, seenAt, m_scene.ownIndex);
    }
    return sample;
  }

 private:
  static glm::vec2 outwardAt(const Stroke& s, float t) {
    const glm::vec2 outward = glm::mix(s.outwardA, s.outwardB, t);
    const float length = glm::length(outward);
    return length > 1e-6f ? outward / length : glm::vec2(1.0f, 0.0f);
  }

  float depthAt(const glm::vec2& pixel) const { return m_scene.own.depthAt(pixel); }
  float distanceAt(float depth) const { return rule::eyeDistance(depth, m_scene.projection); }

  /// Returns the depth of what lies nearer to the eye by that much.
  float lifted(float windowDepth, float mm) const {
    const float lift = rule::depthLift(windowDepth, mm, m_scene.projection);
    return std::clamp(windowDepth - lift, 0.0f, windowDepth);
  }

  std::optional<int> lookFor(const glm::vec2& on, float depth, float tolerance,
                             const glm::vec2& outward) const {
    return contourLook({distanceAt(depth), tolerance, m_scene.probes.sheet, m_scene.probes.reach},
                       [&](float outside) { return distanceAt(depthAt(on + outside * outward)); });
  }

  /// Tests a line as sight.frag.glsl does.
  bool surfaceLineVisible(const glm::vec2& on, float depth, float tolerance) const {
    const glm::vec2 corner = on - 0.5f;
    const float behind = std::max(
        std::max(depthAt(corner), depthAt(corner + glm::vec2(1.0f, 0.0f))),
        std::max(depthAt(corner + glm::vec2(0.0f, 1.0f)), depthAt(corner + glm::vec2(1.0f, 1.0f))));
    return depth <= behind || rule::leavesInSight(distanceAt(behind), distanceAt(depth), tolerance);
  }

  const StrokeScene& m_scene;
};

/// The part of a stroke, as shares of its way, that lies within reach of the picture.
struct NearPart {
  float from = 0.0f;
  float to = 1.0f;
};

NearPart nearPart(const Stroke& s, const glm::vec2& size) {
  constexpr float reach = 0.25f;  // of the picture's sides; moves and widths are less
  NearPart part;
  for (glm::length_t axis = 0; axis < 2; ++axis) {
    const float way = s.b[axis] - s.a[axis];
    const float low = (-reach * size[axis] - s.a[axis]) / way;
    const float high = ((1.0f + reach) * size[axis] - s.a[axis]) / way;
    if (std::isnan(low) || std::isnan(high))
      continue;
    part.from = std::max(part.from, std::min(low, high));
    part.to = std::min(part.to, std::max(low, high));
  }
  return part;
}

/// Returns samples a pixel apart. A stroke that is many times as long as the picture, as close
/// views have them, has some hidden ones for what lies outside.
std::vector<Sample> samples(const InkChain& chain, const StrokeSampler& sampler,
                            const glm::vec2& size) {
  const double whole = 8.0 * double(std::max(size.x, size.y));
  std::vector<Sample> found;
  const auto leaveOut = [&found] { found.resize(found.size() + shortestGap + 1); };
  for (const Stroke& s : chain) {
    const double length = std::ceil(double(glm::distance(s.a, s.b)));
    const bool isLong = !(length <= whole);
    const NearPart part = isLong ? nearPart(s, size) : NearPart();
    if (isLong && !(part.from < part.to && std::isfinite(length))) {
      leaveOut();
      continue;
    }
    const double steps = std::max(1.0, length);
    const double first = isLong ? std::floor(double(part.from) * steps) : 0.0;
    const double last = isLong ? std::ceil(double(part.to) * steps) : steps;
    if (first > 0.0)
      leaveOut();
    for (double i = found.empty() || first > 0.0 ? first : 1.0; i <= last; i += 1.0)
      found.push_back(sampler.sampleAt(s, float(i) / float(steps)));
    if (last < steps)
      leaveOut();
  }
  return found;
}

/// Hides what runs along under an outline.
void hideInked(std::vector<Sample>& all) {
  for (std::size_t from = 0; from < all.size();) {
    std::size_t to = from + 1;
    while (to < all.size() && all[to].inked == all[from].inked)
      ++to;
    if (all[from].inked && to - from > longestCrossing)
      for (std::size_t i = from; i < to; ++i)
        all[i].grade = 0;
    from = to;
  }
}

Veil meanVeil(std::span<const Sample> run) {
  Veil sum{.colour = glm::vec3(0.0f), .transmittance = 0.0f};
  for (const Sample& sample : run) {
    sum.colour += sample.veil.colour;
    sum.transmittance += sample.veil.transmittance;
  }
  return {sum.colour / float(run.size()), sum.transmittance / float(run.size())};
}

/// Returns where the run of samples that begins there ends: at another grade or, where it is long
/// enough to be seen, at a veil of another colour.
std::size_t endOfRun(std::span<const Sample> all, std::size_t from) {
  std::size_t to = from + 1;
  while (to < all.size() && all[to].grade == all[from].grade) {
    const glm::vec3 change = glm::abs(all[to].veil.colour - all[from].veil.colour);
    if (to - from >= shortestShade && std::max({change.r, change.g, change.b}) > sameShade)
      break;
    ++to;
  }
  return to;
}

/// Gives runs of one grade that are too short for a pen the grade of the run before them.
void closeGaps(std::vector<Sample>& all) {
  for (std::size_t from = 0; from < all.size();) {
    std::size_t to = from + 1;
    while (to < all.size() && all[to].grade == all[from].grade)
      ++to;
    const bool between = from > 0 && to < all.size();
    const bool wide = all[from].grade > 0 || all[from].point.halfWidth > 0.0f ||
                      (between && all[from - 1].grade > 0 && all[to].grade > 0);
    if (between && wide && to - from <= shortestGap && all[from - 1].grade > 0) {
      const Sample before = all[from - 1];
      const Sample after = all[to];
      for (std::size_t i = from; i < to; ++i) {
        // Hidden samples were not placed either: they go straight from one side to the other.
        if (all[i].grade == 0) {
          const float t = float(i - from + 1) / float(to - from + 1);
          all[i].point = {glm::mix(before.point.at, after.point.at, t),
                          glm::mix(before.point.halfWidth, after.point.halfWidth, t),
                          glm::mix(before.point.depth, after.point.depth, t)};
        }
        all[i].grade = before.grade;
        all[i].veil = before.veil;
      }
    }
    from = to;
  }
}

}  // namespace

std::vector<VisibleStroke> withinPage(std::vector<VisibleStroke> strokes, const glm::vec2& page) {
  const auto inside = [&page](const StrokePoint& p) {
    const glm::vec2 beyond = glm::max(-p.at, p.at - page);
    return std::max(beyond.x, beyond.y) <= p.halfWidth;
  };
  std::vector<VisibleStroke> kept;
  for (VisibleStroke& stroke : strokes) {
    std::vector<StrokePoint>& points = stroke.points;
    if (std::all_of(points.begin(), points.end(), inside)) {
      kept.push_back(std::move(stroke));
      continue;
    }
    // A line without ends begins where it comes back to the page.
    if (stroke.closed)
      std::rotate(points.begin(), std::find_if_not(points.begin(), points.end(), inside),
                  points.end());
    bool drawing = false;
    for (const StrokePoint& point : points) {
      if (!inside(point)) {
        drawing = false;
        continue;
      }
      if (!drawing)
        kept.push_back({.points = {}, .closed = false, .veil = stroke.veil});
      kept.back().points.push_back(point);
      drawing = true;
    }
  }
  return kept;
}

std::vector<VisibleStroke> visibleStrokes(const InkChain& chain, const StrokeScene& scene) {
  std::vector<VisibleStroke> strokes;
  std::vector<Sample> all = samples(chain, StrokeSampler(scene), scene.stack.size());
  if (all.size() == 2 && chain.front().a == chain.front().b)
    all.pop_back();  // a dot
  hideInked(all);
  closeGaps(all);
  for (std::size_t from = 0; from < all.size();) {
    const std::size_t to = endOfRun(all, from);
    const bool whole = to - from == all.size();
    if (all[from].grade > 0 && (whole || to - from >= shortestMark ||
                                (from > 0 && all[from - 1].grade == all[from].grade))) {
      VisibleStroke& stroke = strokes.emplace_back();
      stroke.closed = whole && chain.size() > 2 && chain.front().a == chain.back().b;
      stroke.veil = meanVeil(std::span(all).subspan(from, to - from));
      // Neighbours of another grade meet without a gap.
      if (from > 0 && all[from - 1].grade > 0)
        stroke.points.push_back(all[from - 1].point);
      for (std::size_t i = from; i < to; ++i)
        stroke.points.push_back(all[i].point);
    }
    from = to;
  }
  return strokes;
}

}  // namespace sline::render
