// SPDX-License-Identifier: Apache-2.0
#include "render/lines/confis.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <optional>
#include <span>

#include "model/base/parallel.h"
#include "render/lines/foreshortening.h"
#include "render/lines/frustum.h"
#include "render/lines/stage_entry.h"
#include "render/lines/view_fields.h"
#include "render/lines/view_scale.h"

namespace sline::render {

namespace {

constexpr std::size_t linesPerTask = 256;
// The share of the margin's width over which it fades at its edge.
constexpr float marginEdge = 0.5f;
// An extremum is told in full from this many times the least |H| on.
constexpr float fullFeature = 2.0f;
// The share of a line's length over which it leaves off at either end.
constexpr float endShare = 0.15f;
// Fainter than this a line is not drawn.
constexpr float faintest = 0.02f;
// Strokes thin out where less than this share of the distance between them is seen.
constexpr float leastAcross = 0.3f;
// Where less than this is seen they come and go as the surface turns. It is more than in hatching,
// as strokes of ConFIS lie where a surface turns away.
constexpr float turnedAway = 0.6f;

/// What a view makes of one point of a line.
struct Seen {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};  ///< on the side that faces the eye
  float strength = 0.0f;   ///< with which a stroke starts here
  float nv = 0.0f;
};

class Picker {
 public:
  Picker(const LineSearch& search, const StreamlineLayout& layout)
      : m_search(search),
        m_layout(layout),
        m_eye(eyeOf(search.camera)),
        m_scale(search.camera),
        m_thickness(threshold(contourMargin)),
        m_leastFeature(std::max(threshold(leastFeature), 1e-3f)),
        m_spacing(threshold(lineSpacing)) {
    if (search.request.aspect > 0.0f)
      m_frustum.emplace(search.camera, search.request.aspect);
  }

  /// Returns the largest scale at which any point of the sphere can be seen, λ per mm; infinite
  /// where the eye is within it.
  float largestScale(const model::Sphere& sphere) const {
    const float middle = m_scale.project(sphere.centre).distanceMm;
    const float perMm = m_scale.perMmAt(middle - sphere.radius);
    return perMm > 0.0f ? perMm : std::numeric_limits<float>::infinity();
  }

  /// Tells whether lines at that distance can be far enough apart at a scale.
  bool shows(float distance, float perMm) const { return 2.0f * distance * perMm > m_spacing; }

  void pick(const Streamline& line, std::vector<Segment>& segments) {
    if (m_frustum && m_frustum->misses(line.bounds))
      return;
    if (!shows(line.distance, largestScale(line.bounds)) || staysWithin(line))
      return;
    const std::span<const StreamlinePoint> points = m_layout.points(line);
    m_seen.resize(points.size());
    m_opacity.resize(points.size());
    bool any = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      m_seen[i] = seen(points[i]);
      any = any || m_seen[i].strength > faintest;
    }
    if (!any)
      return;
    spread(line, points);
    for (std::size_t i = 0; i < points.size(); ++i)
      m_opacity[i] *= presence(line, i);
    const float entry = -std::log2(line.distance / m_search.surface.featureSize);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Seen& a = m_seen[i];
      const Seen& b = m_seen[i + 1];
      if (std::max(m_opacity[i], m_opacity[i + 1]) > faintest && std::max(a.nv, b.nv) > 0.0f)
        segments.push_back({.a = a.position,
                            .b = b.position,
                            .normalA = a.normal,
                            .normalB = b.normal,
                            .opacityA = m_opacity[i],
                            .opacityB = m_opacity[i + 1],
                            .entryA = entry,
                            .entryB = entry,
                            .triangle = points[i + 1].triangle});
    }
  }

 private:
  /// Tells whether all of a line is seen from behind, or lies so far within its contour that no
  /// stroke starts on it.
  bool staysWithin(const Streamline& line) const {
    if (m_search.request.twoSided)
      return false;
    constexpr float rightAngle = 1.57079633f;
    float spread = line.spread;
    glm::vec3 toEye = m_eye.value;
    if (!m_eye.atInfinity) {
      toEye -= line.bounds.centre;
      const float distance = glm::length(toEye);
      if (!(distance > line.bounds.radius))
        return false;
      toEye /= distance;
      spread += std::asin(line.bounds.radius / distance);
    }
    const float angle = std::acos(std::clamp(glm::dot(line.axis, toEye), -1.0f, 1.0f));
    if (angle - spread > rightAngle)
      return true;
    const float x = std::min(m_thickness * line.steepest, 1.0f);
    return line.feature <= m_leastFeature && angle + spread < rightAngle &&
           std::cos(angle + spread) > std::sqrt(x * (2.0f - x));
  }

  float threshold(ConfisThreshold which) const {
    return m_search.request.thresholds.of(LineKind::confis, which);
  }

  Seen seen(const StreamlinePoint& point) const {
    Seen seen{.position = point.position, .normal = normalOf(point)};
    const glm::vec3 v = directionTo(m_eye, point.position);
    seen.nv = glm::dot(seen.normal, v);
    float side = 1.0f;
    if (seen.nv < 0.0f && m_search.request.twoSided) {
      side = -1.0f;
      seen.nv = -seen.nv;
      seen.normal = -seen.normal;
    }
    std::array<float, 6> s{};
    for (std::size_t i = 0; i < s.size(); ++i)
      s[i] = side * glm::unpackHalf1x16(point.s[i]);
    const float bent = v.x * (s[0] * v.x + 2.0f * (s[1] * v.y + s[2] * v.z)) +
                       v.y * (s[3] * v.y + 2.0f * s[4] * v.z) + s[5] * v.z * v.z;
    const float kappa = bent / std::max(1.0f - seen.nv * seen.nv, 1e-6f);
    const float feature = float(point.feature) / featureSteps / m_leastFeature;
    seen.strength = std::max(marginStrength(std::abs(seen.nv), kappa, m_thickness),
                             std::clamp((feature - 1.0f) / (fullFeature - 1.0f), 0.0f, 1.0f));
    return seen;
  }

  /// Lets each point's strength fade along the line, evenly to nothing over its reach. Where
  /// several strokes overlap the strongest counts.
  void spread(const Streamline& line, std::span<const StreamlinePoint> points) {
    const std::size_t count = points.size();
    const float perReach = line.length / (waySteps * line.reach);
    const auto fade = [&](std::size_t i, std::size_t from) {
      const float way = perReach * std::abs(float(points[i].way) - float(points[from].way));
      m_opacity[i] = std::max(m_opacity[i], m_opacity[from] - way);
    };
    for (std::size_t i = 0; i < count; ++i)
      m_opacity[i] = m_seen[i].strength;
    for (std::size_t i = 1; i < count; ++i)
      fade(i, i - 1);
    for (std::size_t i = count - 1; i > 0; --i)
      fade(i - 1, i);
    for (std::size_t i = 0; i < count; ++i) {
      const float share = float(points[i].way) / waySteps;
      m_opacity[i] *= std::min(std::min(share, 1.0f - share) / endShare, 1.0f);
    }
  }

  /// Returns how much of a line its distance from others lets be seen at a point: lines grow from
  /// nothing, and thin out where the surface turns away so that they would close up.
  float presence(const Streamline& line, std::size_t i) const {
    const Seen& s = m_seen[i];
    const float perMm = m_scale.project(s.position).perMm;
    if (!(perMm > 0.0f))
      return 0.0f;
    const glm::vec3 along =
        m_seen[std::min(i + 1, m_seen.size() - 1)].position - m_seen[i > 0 ? i - 1 : 0].position;
    const float across = seenAcross(std::max(s.nv, 1e-3f), along, directionTo(m_eye, s.position));
    const float levels = std::log2(line.distance * perMm * widened(across, turnedAway) / m_spacing);
    return std::clamp(levels + 1.0f, 0.0f, 1.0f) * std::min(1.0f, across / leastAcross);
  }

  const LineSearch& m_search;
  const StreamlineLayout& m_layout;
  model::EyePoint m_eye;
  ViewScale m_scale;
  float m_thickness;
  float m_leastFeature;
  float m_spacing;
  std::optional<Frustum> m_frustum;
  std::vector<Seen> m_seen;
  std::vector<float> m_opacity;
};

}  // namespace

std::unique_ptr<const PreparedLines> prepareConfis(const model::Surface& surface) {
  return std::make_unique<ConfisLines>(surface);
}

float confisEntered(Gamma gamma) {
  return std::clamp(0.5f * (gamma.value() - 1.0f), 0.0f, 1.0f);
}

float marginStrength(float nv, float kappa, float thickness) {
  const float x = std::clamp(thickness * kappa, 0.0f, 1.0f);
  const float edge = std::sqrt(x * (2.0f - x));
  return edge > 0.0f ? std::clamp((1.0f - nv / edge) / marginEdge, 0.0f, 1.0f) : 0.0f;
}

void findConfisLines(const LineSearch& search, std::vector<Segment>& segments) {
  const StreamlineLayout& layout = static_cast<const ConfisLines*>(search.prepared)->layout();
  const auto lines = layout.lines();
  Picker whole(search, layout);
  const float perMm = whole.largestScale(search.surface.boundingSphere);
  const auto end = std::partition_point(lines.begin(), lines.end(), [&](const Streamline& line) {
    return whole.shows(line.distance, perMm);
  });
  const auto count = std::size_t(end - lines.begin());
  std::vector<std::vector<Segment>> parts((count + linesPerTask - 1) / linesPerTask);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    Picker picker(search, layout);
    for (std::size_t i = part * linesPerTask; i < std::min(count, (part + 1) * linesPerTask); ++i)
      picker.pick(lines[i], parts[part]);
  });
  for (const std::vector<Segment>& part : parts)
    segments.insert(segments.end(), part.begin(), part.end());
}

void rankConfisLines(std::vector<Segment>& segments, const model::Surface&, const model::Camera&,
                     float) {
  replaceByRank(segments, [](const Segment&) { return true; });
}

}  // namespace sline::render
