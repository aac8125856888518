// SPDX-License-Identifier: Apache-2.0
#include "render/lines/streamlines/streamline_layout.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "model/base/parallel.h"
#include "render/lines/streamlines/mean_curvature_features.h"
#include "render/lines/streamlines/streamline_room.h"
#include "render/lines/streamlines/streamline_tracer.h"

namespace sline::render {

namespace {

// Distances between lines: the largest and the smallest as a share of F, the smallest as a share of
// the mean edge where that is less, and from one to the next.
constexpr float widest = 0.25f;
constexpr float closest = 1.0f / 120.0f;
constexpr float closestOfEdge = 0.5f;
constexpr float closer = 0.8408964f;  // four steps halve it
// A line ends where it comes nearer than this share of the distance to another.
constexpr float nearestPass = 0.45f;
// Where no line is worth drawing, none is that starts this share of the distance beside it.
constexpr float alikeWithin = 0.2f;
// The most bytes for each triangle of the surface.
constexpr std::size_t mostBytes = 110;
// The fewest and the most lines that are traced together.
constexpr std::size_t fewestAtOnce = 8;
constexpr std::size_t mostAtOnce = 512;
// How far points may be left out, of a mean edge, and how far apart points are at most, of a
// line's reach.
constexpr float leftOut = 0.08f;
constexpr double farthestApart = 1.0 / 6.0;

/// Scrambles the bits of a number, so that neighbours come in no order.
std::uint32_t scrambled(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

using Line = std::vector<TracedPoint>;
using ShapeEntries = std::array<float, 6>;  // of S·F_c

float offChord(const Line& line, std::size_t i, std::size_t from, std::size_t to) {
  const glm::dvec3 chord = line[to].place - line[from].place;
  const glm::dvec3 d = line[i].place - line[from].place;
  const double length2 = glm::dot(chord, chord);
  const double t = length2 > 0.0 ? std::clamp(glm::dot(d, chord) / length2, 0.0, 1.0) : 0.0;
  return float(glm::length(d - t * chord));
}

/// Returns which points of a line are enough.
std::vector<std::size_t> enoughOf(const Line& line, float tolerance, double farthest) {
  std::vector<std::size_t> kept{0};
  while (kept.back() + 1 < line.size()) {
    const std::size_t from = kept.back();
    std::size_t to = from + 1;
    for (std::size_t end = from + 2; end < line.size(); ++end) {
      bool close = line[end].way - line[from].way <= farthest;
      for (std::size_t i = from + 1; close && i < end; ++i)
        close = offChord(line, i, from, end) <= tolerance;
      if (!close)
        break;
      to = end;
    }
    kept.push_back(to);
  }
  return kept;
}

}  // namespace

class StreamlineLayout::Builder {
 public:
  Builder(StreamlineLayout& layout, const model::Surface& surface, const StreamlineLengths& lengths)
      : m_layout(layout),
        m_surface(surface),
        m_lengths(lengths),
        m_neighbours(*surface.mesh),
        m_field(surface),
        m_tracer(m_field, m_neighbours),
        m_features(meanCurvatureFeatures(surface)),
        m_room(*surface.mesh, m_neighbours, 2.0f * closest * surface.featureSize) {
    for (std::uint32_t i = 0; i < m_room.startCount(); ++i)
      if (m_field.direction(m_room.triangle(i)) != glm::dvec3(0.0))
        m_order.push_back(i);
    // Extrema first, then without any order.
    std::sort(m_order.begin(), m_order.end(), [this](std::uint32_t a, std::uint32_t b) {
      const bool firstA = m_features[m_room.triangle(a)] >= usualFeature;
      const bool firstB = m_features[m_room.triangle(b)] >= usualFeature;
      return firstA != firstB ? firstA : scrambled(a) < scrambled(b);
    });
  }

  void build() {
    const float last =
        std::min(closest * m_surface.featureSize, closestOfEdge * m_surface.meanEdge);
    for (float d = widest * m_surface.featureSize; d >= last && d > 0.0f; d *= closer) {
      layAt(d);
      if (m_layout.bytes() > mostBytes * m_surface.mesh->triangleCount())
        break;
    }
    m_layout.m_points.shrink_to_fit();
    m_layout.m_lines.shrink_to_fit();
  }

 private:
  /// Lays lines wherever the others are at least that far away. Some are traced together before it
  /// is known which of them leave room for which; the result is the same for any threads.
  void layAt(float distance) {
    std::size_t next = 0;
    std::size_t atOnce = fewestAtOnce;
    std::vector<std::uint32_t> starts;
    std::vector<Line> lines;
    while (true) {
      starts.clear();
      for (; next < m_order.size() && starts.size() < atOnce; ++next)
        if (m_room.at(m_order[next]) >= distance)
          starts.push_back(m_order[next]);
      if (starts.empty())
        return;
      lines.assign(starts.size(), {});
      parallelFor(starts.size(), 4, [&](std::size_t i) {
        if (m_room.at(starts[i]) >= distance)
          lines[i] = traced(starts[i], distance);
      });
      std::size_t taken = 0;
      for (std::size_t i = 0; i < starts.size(); ++i)
        taken += take(starts[i], lines[i], distance) ? 1 : 0;
      atOnce = std::clamp(4 * taken, fewestAtOnce, mostAtOnce);
    }
  }

  /// Returns the way from the start as far as no other line is near.
  Line traced(std::uint32_t start, float distance) const {
    const StreamlineStart from = m_room.start(start);
    const double reach = m_lengths.reach * m_tracer.length(from.triangle);
    const auto isNear = [&](std::uint32_t triangle, const glm::dvec3& place) {
      return m_room.near(triangle, glm::vec3(place)) < nearestPass * distance;
    };
    Line line = m_tracer.trace(from, false, reach, isNear);
    const Line ahead = m_tracer.trace(from, true, reach, isNear);
    if (line.empty() || ahead.empty())
      return {};
    const double back = line.back().way;
    std::reverse(line.begin(), line.end());
    for (TracedPoint& p : line)
      p.way = back - p.way;
    for (std::size_t i = 1; i < ahead.size(); ++i) {
      line.push_back(ahead[i]);
      line.back().way += back;
    }
    return line;
  }

  bool take(std::uint32_t start, const Line& line, float distance) {
    if (m_room.at(start) < distance)
      return false;
    const double reach = m_lengths.reach * m_tracer.length(m_room.triangle(start));
    const bool worthIt = line.size() >= 2 && line.back().way >= m_lengths.least * 2.0 * reach;
    if (worthIt)
      m_room.add(line, distance);
    else
      m_room.refuse(line, alikeWithin * distance, std::nextafter(distance, 0.0f));
    m_room.limit(start, worthIt ? 0.0f : std::nextafter(distance, 0.0f));
    if (!worthIt)
      return false;
    keep(line, float(reach), distance);
    return true;
  }

  void keep(const Line& line, float reach, float distance) {
    const std::vector<std::size_t> kept =
        enoughOf(line, leftOut * m_surface.meanEdge, farthestApart * double(reach));
    Streamline stored{.first = std::uint32_t(m_layout.m_points.size()),
                      .count = std::uint32_t(kept.size()),
                      .distance = distance,
                      .reach = reach,
                      .length = float(line.back().way)};
    model::Box box;
    glm::vec3 normals(0.0f);
    m_bends.resize(kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
      StreamlinePoint point = pointOf(line[kept[k]], line.back().way, m_bends[k]);
      // What was left out on the way to the middle between two points belongs to the nearer one.
      const std::size_t low = k > 0 ? (kept[k - 1] + kept[k]) / 2 + 1 : 0;
      const std::size_t high = k + 1 < kept.size() ? (kept[k] + kept[k + 1]) / 2 : kept[k];
      float feature = 0.0f;
      for (std::size_t i = low; i <= high; ++i)
        feature = std::max(feature, m_features[line[i].triangle]);
      point.feature = std::uint8_t(std::min(std::lround(featureSteps * feature), 255l));
      stored.feature = std::max(stored.feature, feature);
      stored.steepest = std::max(stored.steepest, steepestAt(line[kept[k]].triangle));
      normals += normalOf(point);
      box.add(point.position);
      m_layout.m_points.push_back(point);
    }
    stored.bounds = {box.centre(), 0.5f * glm::length(box.size())};
    stored.axis = normals / std::max(glm::length(normals), 1e-20f);
    for (std::size_t i = stored.first; i < m_layout.m_points.size(); ++i)
      stored.within =
          std::min(stored.within, glm::dot(stored.axis, normalOf(m_layout.m_points[i])));
    keepBends(stored);
    m_layout.m_lines.push_back(stored);
  }

  void keepBends(Streamline& stored) {
    for (const ShapeEntries& bend : m_bends)
      for (const float entry : bend)
        stored.bend = std::max(stored.bend, std::abs(entry));
    const float steps = bendSteps / std::max(stored.bend, 1e-20f);
    for (std::size_t k = 0; k < m_bends.size(); ++k)
      for (std::size_t i = 0; i < m_bends[k].size(); ++i)
        m_layout.m_points[stored.first + k].s[i] = std::int16_t(std::lround(steps * m_bends[k][i]));
  }

  /// Returns the largest |κ|·F_c at the triangle's corners.
  float steepestAt(std::uint32_t triangle) const {
    float largest = 0.0f;
    for (const std::uint32_t vertex : m_surface.mesh->triangles()[triangle]) {
      const glm::vec2 k = glm::abs(m_surface.curvature.k[vertex]);
      largest = std::max({largest, k.x, k.y});
    }
    return largest * m_surface.filigreeSize;
  }

  /// Returns all of a point but S·F_c, which goes to `s`.
  StreamlinePoint pointOf(const TracedPoint& at, double length, ShapeEntries& s) const {
    const model::Triangle& t = m_surface.mesh->triangles()[at.triangle];
    const std::array<double, 3> share = barycentric(at.at);
    glm::vec3 normal(0.0f);
    s = {};
    for (std::size_t i = 0; i < 3; ++i) {
      const float weight = float(share[i]);
      const glm::vec3& n = m_surface.normals[t[i]];
      const glm::vec3& e1 = m_surface.curvature.e1[t[i]];
      const glm::vec3 e2 = glm::cross(n, e1);
      const glm::vec2 k = weight * m_surface.filigreeSize * m_surface.curvature.k[t[i]];
      normal += weight * n;
      s[0] += k.x * e1.x * e1.x + k.y * e2.x * e2.x;
      s[1] += k.x * e1.x * e1.y + k.y * e2.x * e2.y;
      s[2] += k.x * e1.x * e1.z + k.y * e2.x * e2.z;
      s[3] += k.x * e1.y * e1.y + k.y * e2.y * e2.y;
      s[4] += k.x * e1.y * e1.z + k.y * e2.y * e2.z;
      s[5] += k.x * e1.z * e1.z + k.y * e2.z * e2.z;
    }
    StreamlinePoint point{.position = glm::vec3(at.place), .triangle = at.triangle};
    normal /= std::max(glm::length(normal), 1e-20f);
    point.normal = glm::packSnorm3x10_1x2(glm::vec4(normal, 0.0f));
    point.way = std::uint16_t(std::lround(double(waySteps) * std::min(at.way / length, 1.0)));
    return point;
  }

  StreamlineLayout& m_layout;
  const model::Surface& m_surface;
  StreamlineLengths m_lengths;
  model::FaceNeighbours m_neighbours;
  PrincipalField m_field;
  StreamlineTracer m_tracer;
  std::vector<float> m_features;
  StreamlineRoom m_room;
  std::vector<std::uint32_t> m_order;
  std::vector<ShapeEntries> m_bends;  ///< of the line that is being kept
};

StreamlineLayout::StreamlineLayout(const model::Surface& surface,
                                   const StreamlineLengths& lengths) {
  Builder(*this, surface, lengths).build();
}

std::size_t StreamlineLayout::bytes() const {
  return m_lines.size() * sizeof(Streamline) + m_points.size() * sizeof(StreamlinePoint);
}

}  // namespace sline::render
