// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/question_zone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <utility>

namespace sline::render {

namespace {

using Loop = std::vector<glm::vec2>;  // in cells

/// What of a zone may be left out: cells.
constexpr float leastPart = 12.0f;
/// How far a simplified outline may be from the cells' edges, cells.
constexpr float tolerance = 0.8f;
constexpr std::size_t mostBoxes = 12;

float areaOfLoop(const Loop& loop) {
  float twice = 0.0f;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::vec2& a = loop[i];
    const glm::vec2& b = loop[(i + 1) % loop.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return 0.5f * twice;
}

/// Follows the edges of cells, each with the zone at its right hand as one looks at the picture.
class EdgeWalk {
 public:
  explicit EdgeWalk(const SeenArea& area) {
    for (int y = 0; y < area.grid.rows; ++y)
      for (int x = 0; x < area.grid.columns; ++x)
        if (area.at(x, y)) {
          add(!area.at(x, y - 1), {x, y}, {x + 1, y});
          add(!area.at(x + 1, y), {x + 1, y}, {x + 1, y + 1});
          add(!area.at(x, y + 1), {x + 1, y + 1}, {x, y + 1});
          add(!area.at(x - 1, y), {x, y + 1}, {x, y});
        }
  }

  std::vector<Loop> loops() {
    std::vector<Loop> all;
    while (!m_edges.empty())
      all.push_back(takeLoop());
    return all;
  }

 private:
  using Corner = std::pair<int, int>;

  void add(bool edge, const Corner& from, const Corner& to) {
    if (edge)
      m_edges.emplace(from, to);
  }

  Loop takeLoop() {
    Loop loop;
    const Corner start = m_edges.begin()->first;
    Corner at = start;
    Corner before = at;
    do {
      auto [next, end] = m_edges.equal_range(at);
      // Where two cells touch by a corner the walk turns right, so that each stays by itself.
      if (std::next(next) != end &&
          turn(before, at, std::next(next)->second) > turn(before, at, next->second))
        ++next;
      loop.emplace_back(float(at.first), float(at.second));
      before = at;
      at = next->second;
      m_edges.erase(next);
    } while (at != start);
    return loop;
  }

  static int turn(const Corner& a, const Corner& b, const Corner& c) {
    return (b.first - a.first) * (c.second - b.second) -
           (b.second - a.second) * (c.first - b.first);
  }

  std::multimap<Corner, Corner> m_edges;
};

float distanceToLine(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 along = b - a;
  const float length = glm::dot(along, along);
  const float share =
      length > 0.0f ? std::clamp(glm::dot(p - a, along) / length, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + share * along);
}

/// Marks the corners between two that a simplified line keeps (Douglas and Peucker, 1973).
void markKept(const Loop& loop, std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, loop.size() / 2},
                                                        {loop.size() / 2, loop.size()}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    kept[first] = true;
    std::size_t farthest = first;
    float most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const float far = distanceToLine(loop[i], loop[first], loop[last % loop.size()]);
          far > most) {
        most = far;
        farthest = i;
      }
    if (farthest == first)
      continue;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
}

Loop simplified(const Loop& loop) {
  std::vector<bool> kept(loop.size(), false);
  markKept(loop, kept);
  Loop few;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (kept[i])
      few.push_back(loop[i]);
  return few;
}

/// Inserts the loop into the outline where the two are nearest.
void joinLoop(Loop& outline, const Loop& loop) {
  std::size_t at = 0;
  std::size_t from = 0;
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (std::size_t j = 0; j < loop.size(); ++j)
      if (const glm::vec2 way = outline[i] - loop[j]; glm::dot(way, way) < nearest) {
        nearest = glm::dot(way, way);
        at = i;
        from = j;
      }
  Loop joined(outline.begin(), outline.begin() + std::ptrdiff_t(at) + 1);
  joined.insert(joined.end(), loop.begin() + std::ptrdiff_t(from), loop.end());
  joined.insert(joined.end(), loop.begin(), loop.begin() + std::ptrdiff_t(from) + 1);
  joined.insert(joined.end(), outline.begin() + std::ptrdiff_t(at), outline.end());
  outline = std::move(joined);
}

Loop outlineOf(const SeenArea& area) {
  std::vector<Loop> loops = EdgeWalk(area).loops();
  std::stable_sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
    return std::abs(areaOfLoop(a)) > std::abs(areaOfLoop(b));
  });
  if (loops.empty() || areaOfLoop(loops.front()) < leastPart)
    return {};
  const float least = std::max(leastPart, 0.02f * areaOfLoop(loops.front()));
  Loop outline = simplified(loops.front());
  for (std::size_t i = 1; i < loops.size(); ++i) {
    const float size = areaOfLoop(loops[i]);
    const Loop loop = simplified(loops[i]);
    if (loop.size() >= 3 && (size >= least || -size >= leastPart))
      joinLoop(outline, loop);
  }
  return outline.size() >= 3 ? outline : Loop();
}

struct CellBox {
  int left = 0;
  int top = 0;
  int right = 0;  ///< behind its last column
  int bottom = 0;
  int size() const { return (right - left) * (bottom - top); }
};

/// Returns the largest box of cells that the area has, found by the heights of its columns above
/// each row.
CellBox largestBox(const SeenArea& area) {
  CellBox best;
  std::vector<int> heights(std::size_t(area.grid.columns) + 1, 0);
  std::vector<std::pair<int, int>> open;  // columns from which on it is as high, and how high
  for (int y = 0; y < area.grid.rows; ++y) {
    open.clear();
    for (int x = 0; x <= area.grid.columns; ++x) {
      int& height = heights[std::size_t(x)];
      height = area.at(x, y) ? height + 1 : 0;
      int from = x;
      while (!open.empty() && open.back().second >= height) {
        from = open.back().first;
        const CellBox box{from, y + 1 - open.back().second, x, y + 1};
        if (box.size() > best.size())
          best = box;
        open.pop_back();
      }
      open.emplace_back(from, height);
    }
  }
  return best;
}

std::vector<CellBox> boxesOf(SeenArea area) {
  std::vector<CellBox> boxes;
  const auto whole = std::count(area.cells.begin(), area.cells.end(), true);
  std::ptrdiff_t left = whole;
  while (boxes.size() < mostBoxes && 8 * left > whole) {
    const CellBox box = largestBox(area);
    if (float(box.size()) < leastPart)
      break;
    boxes.push_back(box);
    left -= box.size();
    for (int y = box.top; y < box.bottom; ++y)
      for (int x = box.left; x < box.right; ++x)
        area.cells[std::size_t(y) * std::size_t(area.grid.columns) + std::size_t(x)] = false;
  }
  return boxes;
}

/// Returns how many cells the side of the largest square has.
int largestSquare(const SeenArea& area) {
  int most = 0;
  std::vector<int> above(std::size_t(area.grid.columns) + 1, 0);
  for (int y = 0; y < area.grid.rows; ++y) {
    int diagonal = 0;
    for (int x = 0; x < area.grid.columns; ++x) {
      int& here = above[std::size_t(x) + 1];
      const int side = area.at(x, y) ? 1 + std::min({diagonal, here, above[std::size_t(x)]}) : 0;
      diagonal = std::exchange(here, side);
      most = std::max(most, side);
    }
  }
  return most;
}

}  // namespace

QuestionZone zoneOf(const SeenArea& area, const glm::vec2& sizeMm) {
  const auto share = [&](const glm::vec2& cell) {
    return glm::clamp((area.grid.corner + area.grid.side * cell) / sizeMm, glm::vec2(0.0f),
                      glm::vec2(1.0f));
  };
  QuestionZone zone;
  for (const glm::vec2& corner : outlineOf(area))
    zone.outline.push_back(share(corner));
  for (const CellBox& box : boxesOf(area))
    zone.boxes.push_back({share({box.left, box.top}), share({box.right, box.bottom})});
  zone.thickness = float(largestSquare(area)) * area.grid.side / sizeMm.y;
  return zone;
}

bool isWithin(const std::vector<glm::vec2>& outline, const glm::vec2& place) {
  bool within = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::vec2& a = outline[i];
    const glm::vec2& b = outline[(i + 1) % outline.size()];
    if ((a.y > place.y) != (b.y > place.y) &&
        place.x < a.x + (place.y - a.y) * (b.x - a.x) / (b.y - a.y))
      within = !within;
  }
  return within;
}

}  // namespace sline::render
