// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/streamline_hatching.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <span>

#include "model/base/parallel.h"
#include "render/lines/ground/foreshortening.h"
#include "render/lines/ground/frustum.h"
#include "render/lines/ground/view_fields.h"
#include "render/lines/ground/view_scale.h"

namespace sline::render {

namespace {

constexpr std::size_t hatchLinesPerTask = 256;
// Strokes of hatching run on where strokes of ConFIS, which tell a form's edge, would end: on a
// tube once around, so that no line comes back onto itself.
constexpr StreamlineLengths longHatches{.reach = 2.9, .least = 0.07};
// The share of the light that comes from the eye.
constexpr float fromEye = 0.35f;
// Fainter than this a hatch is not drawn.
constexpr float faintestHatch = 0.03f;
// In the lightest shade that is hatched, lines are this many times as far apart as in the darkest.
constexpr float lightestApart = 4.0f;
// From this shade on a line is as strong as the pen.
constexpr float fullShade = 0.75f;
// Where less than this share of the distance is seen, lines leave as fast as the surface turns
// away.
constexpr float turnedFromEye = 0.4f;
// The share of a line's length over which it tapers at either end.
constexpr float taper = 0.08f;

struct HatchedPoint {
  glm::vec3 position{0.0f};
  glm::vec3 normal{0.0f};  ///< on the side that faces the eye
  float nv = 0.0f;
  float strength = 0.0f;
};

class HatchPicker {
 public:
  HatchPicker(const LineSearch& search, const StreamlineLayout& layout)
      : m_search(search),
        m_layout(layout),
        m_eye(eyeOf(search.camera)),
        m_scale(search.camera),
        m_light(lightOf(search)),
        m_spacing(threshold(hatchingDistance)),
        m_least(std::min(threshold(leastShade), 0.99f)) {
    if (search.request.aspect > 0.0f)
      m_frustum.emplace(search.camera, search.request.aspect);
  }

  /// Tells whether lines at that distance can be far enough apart anywhere on the sphere.
  bool shows(float distance, const model::Sphere& sphere) const {
    const float middle = m_scale.project(sphere.centre).distanceMm;
    const float perMm = m_scale.perMmAt(middle - sphere.radius);
    return !(perMm > 0.0f) || 2.0f * distance * perMm > m_spacing;
  }

  void pick(const Streamline& line, std::vector<Segment>& segments) {
    if ((m_frustum && m_frustum->misses(line.bounds)) || !shows(line.distance, line.bounds))
      return;
    const std::span<const StreamlinePoint> points = m_layout.points(line);
    m_points.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      m_points[i] = placed(points[i]);
    for (std::size_t i = 0; i < points.size(); ++i)
      m_points[i].strength = strength(line, points, i);
    const float entry = -std::log2(line.distance / m_search.surface.featureSize);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const HatchedPoint& a = m_points[i];
      const HatchedPoint& b = m_points[i + 1];
      if (std::max(a.strength, b.strength) > faintestHatch && std::max(a.nv, b.nv) > 0.0f)
        segments.push_back({.a = a.position,
                            .b = b.position,
                            .normalA = a.normal,
                            .normalB = b.normal,
                            .opacityA = a.strength,
                            .opacityB = b.strength,
                            .entryA = entry,
                            .entryB = entry,
                            .triangle = points[i + 1].triangle});
    }
  }

 private:
  static glm::vec3 lightOf(const LineSearch& search) {
    const model::CameraFrame frame = model::cameraFrame(search.camera);
    const glm::vec3& l = search.request.light;
    return glm::normalize(l.x * frame.right + l.y * frame.up + l.z * frame.back);
  }

  float threshold(StreamlineHatchingThreshold which) const {
    return m_search.request.thresholds.of(LineKind::hatchingStreamline, which);
  }

  HatchedPoint placed(const StreamlinePoint& point) const {
    HatchedPoint p{.position = point.position, .normal = normalOf(point)};
    p.nv = glm::dot(p.normal, directionTo(m_eye, p.position));
    if (p.nv < 0.0f && m_search.request.twoSided) {
      p.normal = -p.normal;
      p.nv = -p.nv;
    }
    return p;
  }

  /// Returns how strong the line is at a point: by its shade, as far as lines at that distance are
  /// wanted in it.
  float strength(const Streamline& line, std::span<const StreamlinePoint> points,
                 std::size_t i) const {
    const HatchedPoint& p = m_points[i];
    const float perMm = m_scale.project(p.position).perMm;
    if (!(p.nv > 0.0f) || !(perMm > 0.0f))
      return 0.0f;
    const glm::vec3 toEye = directionTo(m_eye, p.position);
    const float shade = (hatchingShade(p.normal, toEye, m_light) - m_least) / (1.0f - m_least);
    if (!(shade > 0.0f))
      return 0.0f;
    const glm::vec3 along = m_points[std::min(i + 1, m_points.size() - 1)].position -
                            m_points[i > 0 ? i - 1 : 0].position;
    const float across = widened(seenAcross(p.nv, along, toEye), turnedFromEye);
    const float wanted = m_spacing * std::pow(lightestApart, 1.0f - shade);
    const float levels = std::log2(line.distance * perMm * across / wanted);
    const float way = float(points[i].way) / waySteps;
    const float ends = std::min(std::min(way, 1.0f - way) / taper, 1.0f);
    return std::clamp(1.0f + 2.0f * levels, 0.0f, 1.0f) *
           std::pow(std::min(shade / fullShade, 1.0f), 1.2f) * ends;
  }

  const LineSearch& m_search;
  const StreamlineLayout& m_layout;
  model::EyePoint m_eye;
  ViewScale m_scale;
  glm::vec3 m_light;
  float m_spacing;
  float m_least;
  std::optional<Frustum> m_frustum;
  std::vector<HatchedPoint> m_points;
};

}  // namespace

HatchingStreamlines::HatchingStreamlines(const model::Surface& surface)
    : m_layout(surface, longHatches) {}

std::unique_ptr<const PreparedLines> prepareStreamlineHatching(const model::Surface& surface) {
  return std::make_unique<HatchingStreamlines>(surface);
}

float hatchingShade(const glm::vec3& normal, const glm::vec3& toEye, const glm::vec3& toLight) {
  const float lit = std::max(glm::dot(normal, toLight), 0.0f);
  const float facing = std::max(glm::dot(normal, toEye), 0.0f);
  return 1.0f - std::clamp((1.0f - fromEye) * lit + fromEye * facing, 0.0f, 1.0f);
}

void findStreamlineHatching(const LineSearch& search, std::vector<Segment>& segments) {
  const StreamlineLayout& layout =
      static_cast<const HatchingStreamlines*>(search.prepared)->layout();
  const auto lines = layout.lines();
  const HatchPicker whole(search, layout);
  const auto end = std::partition_point(lines.begin(), lines.end(), [&](const Streamline& line) {
    return whole.shows(line.distance, search.surface.boundingSphere);
  });
  const auto count = std::size_t(end - lines.begin());
  std::vector<std::vector<Segment>> parts((count + hatchLinesPerTask - 1) / hatchLinesPerTask);
  parallelFor(parts.size(), 1, [&](std::size_t part) {
    HatchPicker picker(search, layout);
    const std::size_t last = std::min(count, (part + 1) * hatchLinesPerTask);
    for (std::size_t i = part * hatchLinesPerTask; i < last; ++i)
      picker.pick(lines[i], parts[part]);
  });
  for (const std::vector<Segment>& part : parts)
    segments.insert(segments.end(), part.begin(), part.end());
}

}  // namespace sline::render
