// SPDX-License-Identifier: Apache-2.0
#include "render/lines/techniques/confis.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "model/base/parallel.h"
#include "render/lines/ground/foreshortening.h"
#include "render/lines/ground/frustum.h"
#include "render/lines/ground/stage_entry.h"
#include "render/lines/ground/view_fields.h"
#include "render/lines/ground/view_scale.h"

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

/// What a view makes of some points of a line, an array of each, so that several are reckoned at
/// once.
struct Seen {
  static constexpr std::size_t count = 8;
  using Floats = std::array<float, count>;
  std::array<Floats, 3> toEye;   ///< unit
  std::array<Floats, 3> normal;  ///< on the side that faces the eye
  std::array<Floats, 6> s;       ///< S in the line's steps
  Floats nv;                     ///< the cosine between the two; below 0 where the back is seen
  Floats side;                   ///< -1 where the surface is seen from within
  Floats strength;               ///< with which a stroke starts there

  static glm::vec3 at(const std::array<Floats, 3>& vectors, std::size_t i) {
    return {vectors[0][i], vectors[1][i], vectors[2][i]};
  }
};

/// `marginStrength` of x = T·κv, without a branch.
float marginOf(float nv, float x) {
  const float held = std::clamp(x, 0.0f, 1.0f);
  const float squared = held * (2.0f - held);
  const float edge = std::sqrt(squared > 1e-12f ? squared : 1e-12f);
  const float inner = std::clamp((1.0f - nv / edge) / marginEdge, 0.0f, 1.0f);
  return squared > 0.0f ? inner : 0.0f;
}

/// Returns the largest nv up to which the margin may reach where no |κ|·F_c is above `steepest`.
float marginReach(float thickness, float steepest) {
  const float x = std::min(thickness * steepest, 1.0f);
  return std::sqrt(x * (2.0f - x));
}

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
    if (!findStrengths(line, points))
      return;
    spread(line, points);
    bool beside = false;  // the point before is seen from the front
    bool here = nvAt(0) > 0.0f;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool next = i + 1 < points.size() && nvAt(i + 1) > 0.0f;
      if (m_opacity[i] > faintest && (beside || here || next))
        m_opacity[i] *= presence(line, points, i);
      beside = here;
      here = next;
    }
    const float entry = -std::log2(line.distance / m_search.surface.featureSize);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (std::max(m_opacity[i], m_opacity[i + 1]) > faintest &&
          std::max(nvAt(i), nvAt(i + 1)) > 0.0f)
        segments.push_back({.a = points[i].position,
                            .b = points[i + 1].position,
                            .normalA = normalAt(i),
                            .normalB = normalAt(i + 1),
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
    glm::vec3 toEye = m_eye.value;
    float sine = 0.0f;  // of the angle under which the eye sees half of the line's sphere
    if (!m_eye.atInfinity) {
      toEye -= line.bounds.centre;
      const float distance = glm::length(toEye);
      if (!(distance > line.bounds.radius))
        return false;
      toEye /= distance;
      sine = line.bounds.radius / distance;
    }
    // No nv on the line is farther from that of the axis than by this angle.
    const float cosine = std::sqrt(1.0f - sine * sine);
    const float within = std::sqrt(std::max(1.0f - line.within * line.within, 0.0f));
    const float cosFar = line.within * cosine - within * sine;
    const float sinFar = within * cosine + line.within * sine;
    if (!(line.within > 0.0f && cosFar > 0.0f))
      return false;
    const float nv = glm::dot(line.axis, toEye);
    if (nv < -sinFar)
      return true;
    const float least = nv * cosFar - std::sqrt(std::max(1.0f - nv * nv, 0.0f)) * sinFar;
    return line.feature <= m_leastFeature && least > marginReach(m_thickness, line.steepest);
  }

  /// Finds with which strength a stroke starts at each point; tells whether any does.
  bool findStrengths(const Streamline& line, std::span<const StreamlinePoint> points) {
    const std::size_t blocks = (points.size() + Seen::count - 1) / Seen::count;
    m_seen.resize(blocks);
    m_opacity.resize(points.size());
    int inFront = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
      look(m_seen[b], points.subspan(b * Seen::count));
      for (const float nv : m_seen[b].nv)
        inFront += nv > 0.0f ? 1 : 0;
    }
    if (inFront == 0)
      return false;
    const float reach = marginReach(m_thickness, line.steepest);
    bool any = false;
    for (std::size_t b = 0; b < blocks; ++b) {
      Seen& seen = m_seen[b];
      const auto some = points.subspan(b * Seen::count);
      seen.strength.fill(0.0f);
      int within = 0;
      for (const float nv : seen.nv)
        within += std::abs(nv) < reach ? 1 : 0;
      if (within > 0)
        addMargin(seen, line, some);
      if (line.feature > m_leastFeature)
        addFeatures(seen, some);
      for (std::size_t i = 0; i < std::min(some.size(), Seen::count); ++i) {
        m_opacity[b * Seen::count + i] = seen.strength[i];
        any = any || seen.strength[i] > faintest;
      }
    }
    return any;
  }
  float nvAt(std::size_t i) const { return m_seen[i / Seen::count].nv[i % Seen::count]; }
  glm::vec3 normalAt(std::size_t i) const {
    return Seen::at(m_seen[i / Seen::count].normal, i % Seen::count);
  }
  glm::vec3 toEyeAt(std::size_t i) const {
    return Seen::at(m_seen[i / Seen::count].toEye, i % Seen::count);
  }

  float threshold(ConfisThreshold which) const {
    return m_search.request.thresholds.of(LineKind::confis, which);
  }

  /// Finds how each point is seen; where there are too few the last stands in.
  void look(Seen& seen, std::span<const StreamlinePoint> points) const {
    auto& [vx, vy, vz] = seen.toEye;
    auto& [nx, ny, nz] = seen.normal;
    std::array<std::uint32_t, Seen::count> packed;
    for (std::size_t i = 0; i < Seen::count; ++i) {
      const StreamlinePoint& point = points[std::min(i, points.size() - 1)];
      packed[i] = point.normal;
      const glm::vec3 v = m_eye.atInfinity ? m_eye.value : m_eye.value - point.position;
      vx[i] = v.x;
      vy[i] = v.y;
      vz[i] = v.z;
    }
    const bool twoSided = m_search.request.twoSided;
    for (std::size_t i = 0; i < Seen::count; ++i) {
      const float squared = vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i];
      const float shorten = 1.0f / std::sqrt(squared > 1e-30f ? squared : 1e-30f);
      vx[i] *= shorten;
      vy[i] *= shorten;
      vz[i] *= shorten;
      nx[i] = normalComponent(packed[i], 0);
      ny[i] = normalComponent(packed[i], 1);
      nz[i] = normalComponent(packed[i], 2);
      const float nv = nx[i] * vx[i] + ny[i] * vy[i] + nz[i] * vz[i];
      const float side = twoSided && nv < 0.0f ? -1.0f : 1.0f;
      seen.side[i] = side;
      seen.nv[i] = side * nv;
      nx[i] *= side;
      ny[i] *= side;
      nz[i] *= side;
    }
  }

  /// Adds how strongly each point belongs to the contour's margin.
  void addMargin(Seen& seen, const Streamline& line,
                 std::span<const StreamlinePoint> points) const {
    for (std::size_t i = 0; i < Seen::count; ++i)
      for (std::size_t c = 0; c < seen.s.size(); ++c)
        seen.s[c][i] = float(points[std::min(i, points.size() - 1)].s[c]);
    const auto& [xx, xy, xz, yy, yz, zz] = seen.s;
    const auto& [vx, vy, vz] = seen.toEye;
    const float thickness = m_thickness * line.bend / bendSteps;
    for (std::size_t i = 0; i < Seen::count; ++i) {
      const float bent = vx[i] * (xx[i] * vx[i] + 2.0f * (xy[i] * vy[i] + xz[i] * vz[i])) +
                         vy[i] * (yy[i] * vy[i] + 2.0f * yz[i] * vz[i]) + zz[i] * vz[i] * vz[i];
      const float nv = seen.nv[i];
      const float across = 1.0f - nv * nv;
      const float kappa = seen.side[i] * bent / (across > 1e-6f ? across : 1e-6f);
      seen.strength[i] = marginOf(std::abs(nv), thickness * kappa);
    }
  }

  void addFeatures(Seen& seen, std::span<const StreamlinePoint> points) const {
    for (std::size_t i = 0; i < std::min(points.size(), Seen::count); ++i) {
      const float feature = float(points[i].feature) / featureSteps / m_leastFeature;
      const float strength = std::min((feature - 1.0f) / (fullFeature - 1.0f), 1.0f);
      seen.strength[i] = std::max(seen.strength[i], strength);
    }
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
  float presence(const Streamline& line, std::span<const StreamlinePoint> points,
                 std::size_t i) const {
    const float perMm = m_scale.project(points[i].position).perMm;
    if (!(perMm > 0.0f))
      return 0.0f;
    const glm::vec3 along =
        points[std::min(i + 1, points.size() - 1)].position - points[i > 0 ? i - 1 : 0].position;
    const float across = seenAcross(std::max(nvAt(i), 1e-3f), along, toEyeAt(i));
    const float apart = line.distance * perMm * widened(across, turnedAway) / m_spacing;
    const float grown = apart < 1.0f ? std::max(std::log2(apart) + 1.0f, 0.0f) : 1.0f;
    return grown * std::min(1.0f, across / leastAcross);
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
  return marginOf(nv, thickness * kappa);
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
