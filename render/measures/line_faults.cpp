// SPDX-License-Identifier: Apache-2.0
#include "render/measures/line_faults.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <unordered_map>

namespace sline::render {

namespace {

// Opposite points of an outline: their normals differ by at least 143°, and they lie within this
// many λ of straight across.
constexpr float oppositeCosine = -0.8f;
constexpr float acrossSlack = 0.5f;

/// Finds what lies near a place of the picture, in cells of a given side.
template <class T>
class Cells {
 public:
  explicit Cells(float side) : m_side(side) {}

  void add(const glm::vec2& a, const glm::vec2& b, const T& value) {
    const glm::ivec2 low = cellOf(glm::min(a, b));
    const glm::ivec2 high = cellOf(glm::max(a, b));
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        m_cells[key(x, y)].push_back(value);
  }
  template <class Body>
  void forEachNear(const glm::vec2& p, const Body& body) const {
    const glm::ivec2 middle = cellOf(p);
    for (int y = middle.y - 1; y <= middle.y + 1; ++y)
      for (int x = middle.x - 1; x <= middle.x + 1; ++x)
        if (const auto cell = m_cells.find(key(x, y)); cell != m_cells.end())
          for (const T& value : cell->second)
            body(value);
  }

 private:
  glm::ivec2 cellOf(const glm::vec2& p) const {
    return {int(std::floor(p.x / m_side)), int(std::floor(p.y / m_side))};
  }
  static std::int64_t key(int x, int y) { return std::int64_t(x) * 1'000'003 + y; }

  float m_side;
  std::unordered_map<std::int64_t, std::vector<T>> m_cells;
};

struct Piece {
  glm::vec2 a;
  glm::vec2 b;
};

float distanceTo(const Piece& piece, const glm::vec2& p) {
  const glm::vec2 d = piece.b - piece.a;
  const float squared = glm::dot(d, d);
  const float t =
      squared > 0.0f ? std::clamp(glm::dot(p - piece.a, d) / squared, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, piece.a + t * d);
}

/// A point of an outline, exact and as drawn; λ.
struct OutlinePoint {
  glm::vec2 at;
  glm::vec2 outward;
  float moved;  ///< outwards
};

/// Tells whether a segment lies before the eye, on the page or beside it.
bool showsOn(const PictureView& view, const Segment& s) {
  const PictureView::Point a = view.project(s.a);
  const PictureView::Point b = view.project(s.b);
  const glm::vec2 margin = 0.1f * view.size();
  const auto inside = [&](const PictureView::Point& p) {
    return p.w > 0.0f && glm::all(glm::greaterThan(p.pixel, -margin)) &&
           glm::all(glm::lessThan(p.pixel, view.size() + margin));
  };
  return inside(a) && inside(b);
}

bool onPage(const PictureView& view, const glm::vec3& p) {
  const PictureView::Point at = view.project(p);
  return at.w > 0.0f && glm::all(glm::greaterThan(at.pixel, glm::vec2(0.0f))) &&
         glm::all(glm::lessThan(at.pixel, view.size()));
}

void addWidths(const PictureView& view, const std::vector<Segment>& outlines, CurveFaults& faults) {
  const float unit = view.outputUnit();
  Cells<OutlinePoint> cells(thinWidth);
  std::vector<OutlinePoint> points;
  for (const Segment& s : outlines) {
    if (!showsOn(view, s))
      continue;
    const glm::vec2 outward = view.projectedDirection(s.a, s.normalA);
    const glm::vec2 at = view.project(s.a).pixel / unit;
    const glm::vec2 drawn = view.project(s.a + s.moveA).pixel / unit;
    if (!(glm::length(outward) > 0.5f))
      continue;
    points.push_back({at, glm::normalize(outward), glm::dot(drawn - at, glm::normalize(outward))});
    cells.add(at, at, points.back());
  }
  for (const OutlinePoint& p : points) {
    float width = thinWidth;
    float drawn = 0.0f;
    cells.forEachNear(p.at, [&](const OutlinePoint& q) {
      const glm::vec2 way = q.at - p.at;
      const float inwards = -glm::dot(way, p.outward);
      if (inwards > 0.5f && inwards < width && glm::dot(p.outward, q.outward) < oppositeCosine &&
          glm::length(way + inwards * p.outward) < acrossSlack) {
        width = inwards;
        drawn = inwards + p.moved + q.moved;
      }
    });
    if (width < thinWidth) {
      faults.exactWidth += double(width);
      faults.drawnWidth += double(drawn);
    }
  }
}

}  // namespace

void addFaults(const PictureView& view, const LineSet& exact, const LineSet& curves,
               CurveFaults& faults) {
  const float unit = view.outputUnit();
  // Curves are asked for on the page alone, but lines beside it may be the nearest.
  constexpr float farthest = 6.0f;  // λ
  for (std::size_t kind = 0; kind < lineKindCount; ++kind) {
    Cells<Piece> cells(farthest);
    for (const Segment& s : exact[LineKind(kind)]) {
      if (!showsOn(view, s))
        continue;
      const Piece piece{view.project(s.a).pixel / unit, view.project(s.b).pixel / unit};
      cells.add(piece.a, piece.b, piece);
    }
    for (const Segment& s : curves[LineKind(kind)])
      for (const float t : {0.0f, 0.5f}) {
        if (std::max(s.opacityA, s.opacityB) < 0.01f)
          continue;
        if (!onPage(view, s.a))
          continue;
        const glm::vec3 place = glm::mix(s.a + s.moveA, s.b + s.moveB, t);
        const glm::vec2 at = view.project(place).pixel / unit;
        float nearest = farthest;
        cells.forEachNear(
            at, [&](const Piece& piece) { nearest = std::min(nearest, distanceTo(piece, at)); });
        faults.distances[kind].push_back(nearest);
      }
  }
  addWidths(view, curves[LineKind::contour], faults);
}

float percentile(std::vector<float> values, double share) {
  if (values.empty())
    return 0.0f;
  const auto at =
      values.begin() + std::ptrdiff_t(std::min(double(values.size()) - 1.0,
                                               std::ceil(share * double(values.size() - 1))));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace sline::render
