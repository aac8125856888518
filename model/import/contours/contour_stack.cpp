// SPDX-License-Identifier: Apache-2.0
#include "model/import/contours/contour_stack.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace sline::model {

namespace {

/// Slices up to this many spacings apart still belong to one body: two in a row may be missing.
constexpr double farthestGap = 3.5;
/// Contours in planes that differ by less are in one slice, mm.
constexpr double samePlane = 0.05;
constexpr std::size_t planesTried = 8;

/// Returns twice the area vector (Newell).
glm::dvec3 areaVector(const Contour& contour) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin = contour.front();
  for (std::size_t i = 0; i < contour.size(); ++i)
    sum += glm::cross(contour[i] - origin, contour[(i + 1) % contour.size()] - origin);
  return sum;
}

struct Span {
  double low = 0.0;
  double high = 0.0;
  double size() const { return high - low; }
};

Span along(const Contour& contour, const glm::dvec3& normal) {
  Span span{glm::dot(contour.front(), normal), glm::dot(contour.front(), normal)};
  for (const glm::dvec3& p : contour) {
    const double d = glm::dot(p, normal);
    span = {std::min(span.low, d), std::max(span.high, d)};
  }
  return span;
}

/// Tells whether a contour counts as drawn in planes of this normal: coordinates are often rounded
/// to 0.01 mm.
bool liesIn(const Contour& contour, const glm::dvec3& normal) {
  return along(contour, normal).size() <= 0.3;
}

/// Returns the normal that most contours agree on, pointing so that its largest component is
/// positive; nothing where no contour has an area.
std::optional<glm::dvec3> commonNormal(std::span<const Contour> contours) {
  std::vector<glm::dvec3> areas;
  areas.reserve(contours.size());
  for (const Contour& contour : contours)
    areas.push_back(areaVector(contour));
  std::vector<std::size_t> order(contours.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return glm::dot(areas[a], areas[a]) > glm::dot(areas[b], areas[b]);
  });
  std::vector<glm::dvec3> tried;
  std::optional<glm::dvec3> best;
  std::size_t most = 0;
  for (const std::size_t i : order) {
    const double length = glm::length(areas[i]);
    if (!(length > 1e-6) || tried.size() == planesTried)
      break;
    const glm::dvec3 normal = areas[i] / length;
    const bool known = std::any_of(tried.begin(), tried.end(), [&](const glm::dvec3& other) {
      return std::abs(glm::dot(normal, other)) > 0.996;
    });
    if (known)
      continue;
    tried.push_back(normal);
    const auto count = std::size_t(std::count_if(
        contours.begin(), contours.end(), [&](const Contour& c) { return liesIn(c, normal); }));
    if (count > most) {
      most = count;
      best = normal;
    }
  }
  if (!best)
    return std::nullopt;
  const glm::dvec3 size = glm::abs(*best);
  const int main = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  // Rounded coordinates do not tilt a plane.
  if (size[main] > 0.99999) {
    glm::dvec3 axis(0.0);
    axis[main] = 1.0;
    return axis;
  }
  return (*best)[main] < 0.0 ? -*best : *best;
}

glm::dmat3 axesFor(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  glm::dvec3 first(0.0);
  first[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
  const glm::dvec3 u = glm::normalize(first - glm::dot(first, normal) * normal);
  return {u, glm::cross(normal, u), normal};
}

/// Returns the middle of the distances between neighbours that are not one plane; 0 without any.
double middleGap(const std::vector<double>& offsets) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < offsets.size(); ++i)
    if (offsets[i] - offsets[i - 1] > samePlane)
      gaps.push_back(offsets[i] - offsets[i - 1]);
  if (gaps.empty())
    return 0.0;
  std::nth_element(gaps.begin(), gaps.begin() + std::ptrdiff_t(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2];
}

std::vector<double> sortedOffsets(std::span<const Contour> contours, const glm::dvec3& normal) {
  std::vector<double> offsets;
  for (const Contour& contour : contours)
    if (liesIn(contour, normal)) {
      const Span span = along(contour, normal);
      offsets.push_back(0.5 * (span.low + span.high));
    }
  std::sort(offsets.begin(), offsets.end());
  return offsets;
}

using GridPoint = std::pair<std::int64_t, std::int64_t>;
GridPoint gridPointOf(const glm::dvec2& p) {
  return {std::llround(p.x * 1000.0), std::llround(p.y * 1000.0)};
}

/// Returns the polygon's corners sorted, so that they are the same wherever and in whichever
/// direction it begins.
std::vector<GridPoint> canonicalLoop(const std::vector<glm::dvec2>& polygon) {
  std::vector<GridPoint> places;
  places.reserve(polygon.size());
  for (const glm::dvec2& p : polygon)
    places.push_back(gridPointOf(p));
  std::sort(places.begin(), places.end());
  return places;
}

/// Collects the polygons of one slice and makes its edges; those that occur an even number of times
/// are left out.
class OutlineBuilder {
 public:
  bool add(const std::vector<glm::dvec2>& polygon) {
    if (!m_seen.try_emplace(canonicalLoop(polygon), true).second)
      return false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      glm::dvec2 a = polygon[i];
      glm::dvec2 b = polygon[(i + 1) % polygon.size()];
      GridPoint from = gridPointOf(a);
      GridPoint to = gridPointOf(b);
      if (from == to)
        continue;
      // The edge is always written the same way round, so that the order of contours changes no
      // bit.
      if (to < from) {
        std::swap(from, to);
        std::swap(a, b);
      }
      Row& row = m_edges[{from, to}];
      row.edge = {a, b};
      row.odd = !row.odd;
    }
    m_points += polygon.size();
    return true;
  }
  SliceOutline outline(double offset) const {
    SliceOutline slice{.offset = offset, .points = m_points};
    for (const auto& [key, row] : m_edges)
      if (row.odd)
        slice.edges.push_back(row.edge);
    return slice;
  }

 private:
  struct Row {
    std::array<glm::dvec2, 2> edge;
    bool odd = false;
  };
  std::map<std::pair<GridPoint, GridPoint>, Row> m_edges;
  std::map<std::vector<GridPoint>, bool> m_seen;
  std::size_t m_points = 0;
};

}  // namespace

double usualSpacing(std::span<const Contour> contours) {
  const std::optional<glm::dvec3> normal = commonNormal(contours);
  return normal ? middleGap(sortedOffsets(contours, *normal)) : 0.0;
}

ContourStacks stacksOf(std::span<const Contour> contours, double spacing) {
  ContourStacks result;
  const std::optional<glm::dvec3> normal = commonNormal(contours);
  if (!normal) {
    result.outOfPlane = contours.size();
    return result;
  }
  const std::vector<double> offsets = sortedOffsets(contours, *normal);
  result.outOfPlane = contours.size() - offsets.size();
  const double own = middleGap(offsets);
  const double usual = own > 0.0 ? own : spacing;
  const double merged = std::max(samePlane, 0.1 * usual);
  const glm::dmat3 axes = axesFor(*normal);

  std::vector<double> planes;
  for (const double offset : offsets)
    if (planes.empty() || offset - planes.back() > merged)
      planes.push_back(offset);
  std::vector<OutlineBuilder> builders(planes.size());
  for (const Contour& contour : contours) {
    if (!liesIn(contour, *normal))
      continue;
    const Span span = along(contour, *normal);
    const auto next =
        std::upper_bound(planes.begin(), planes.end(), 0.5 * (span.low + span.high) + 1e-9);
    std::vector<glm::dvec2> polygon;
    for (const glm::dvec3& p : contour)
      polygon.emplace_back(glm::dot(p, axes[0]), glm::dot(p, axes[1]));
    if (!builders[std::size_t(next - planes.begin()) - 1].add(polygon))
      ++result.repeated;
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double gap = i > 0 ? planes[i] - planes[i - 1] : 0.0;
    if (i == 0 || gap > farthestGap * usual) {
      result.stacks.push_back({axes, {}, usual});
      result.widestGap = std::max(result.widestGap, gap);
    } else if (gap > 1.5 * usual) {
      result.missing += std::size_t(std::llround(gap / usual)) - 1;
    }
    result.stacks.back().slices.push_back(builders[i].outline(planes[i]));
  }
  return result;
}

}  // namespace sline::model
