// SPDX-License-Identifier: Apache-2.0
#include "render/measures/line_steadiness.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <unordered_map>

#include "render/vectors/layer_stack.h"

namespace sline::render {

namespace {

// A dash's point lies in a gap where no dash is nearer than this, λ.
constexpr float dashReach = 0.75f;

/// Finds the heaviest ink around a pixel.
class InkMap {
 public:
  InkMap(const std::vector<InkLine>& lines, float reach) : m_reach(reach) {
    for (const InkLine& line : lines)
      for (const InkPoint& p : line.points)
        m_cells[cellOf(p.at, 0, 0)].push_back({p.at, p.weight});
  }

  float heaviestAt(const glm::vec2& pixel) const {
    float heaviest = 0.0f;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (const auto cell = m_cells.find(cellOf(pixel, x, y)); cell != m_cells.end())
          for (const auto& [at, weight] : cell->second)
            if (glm::distance(at, pixel) <= m_reach)
              heaviest = std::max(heaviest, weight);
    return heaviest;
  }

 private:
  std::int64_t cellOf(const glm::vec2& pixel, int x, int y) const {
    return (std::int64_t(std::floor(pixel.x / m_reach)) + x) * 1'000'003 +
           std::int64_t(std::floor(pixel.y / m_reach)) + y;
  }

  float m_reach;
  std::unordered_map<std::int64_t, std::vector<std::pair<glm::vec2, float>>> m_cells;
};

/// Looks for the lines of one picture in another.
class Search {
 public:
  Search(const InkFrame& in, LinePops& pops)
      : m_in(in), m_stack(in.layers, in.view.size()), m_pops(pops) {}

  void add(const StructureInk& from, std::size_t index) {
    const InkMap ink(m_in.structures[index].lines, popReach * m_in.unit());
    for (const InkLine& line : from.lines)
      addLine(line, ink, index);
    const InkMap dashes(m_in.structures[index].dashes, dashReach * m_in.unit());
    for (const InkLine& dash : from.dashes)
      for (std::size_t i = 1; i < dash.points.size(); ++i) {
        const double step =
            double(glm::distance(dash.points[i].at, dash.points[i - 1].at) / m_in.unit());
        m_pops.dashes += step;
        if (dashes.heaviestAt(m_in.view.project(dash.points[i].place).pixel) == 0.0f)
          m_pops.crawled += step;
      }
  }

 private:
  void addLine(const InkLine& line, const InkMap& ink, std::size_t index) {
    double stretch = 0.0;
    const auto finish = [&] {
      if (stretch > double(popStretch)) {
        m_pops.popped += stretch;
      }
      if (stretch > double(flickerStretch)) {
        m_pops.flickered += stretch;
        m_pops.longest = std::max(m_pops.longest, stretch);
        m_pops.where[m_in.structures[index].name][std::size_t(line.kind)] += stretch;
      }
      stretch = 0.0;
    };
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const InkPoint& p = line.points[i];
      const double step = double(glm::distance(p.at, line.points[i - 1].at) / m_in.unit());
      if (p.weight >= popLoss)
        m_pops.drawn += 0.5 * step;
      if (pops(p, ink, index))
        stretch += step;
      else
        finish();
    }
    finish();
  }

  bool pops(const InkPoint& p, const InkMap& ink, std::size_t index) const {
    if (p.weight < popLoss)
      return false;
    const glm::vec2 pixel = m_in.view.project(p.place).pixel;
    const glm::vec2 size = m_in.view.size();
    if (pixel.x < 0.0f || pixel.y < 0.0f || pixel.x >= size.x || pixel.y >= size.y)
      return false;
    const float there = ink.heaviestAt(pixel);
    return there < 0.5f * p.weight && p.weight - there >= popLoss && !covered(p.place, index);
  }

  bool covered(const glm::vec3& place, std::size_t index) const {
    const float mm = popCoverDepth * m_in.unit() * m_in.view.millimetresPerPixel(place);
    const PictureView::Point lifted =
        m_in.view.project(place + mm * m_in.view.toPatient({0.0f, 0.0f, 1.0f}));
    return m_in.layers[index].depthAt(lifted.pixel) < lifted.depth ||
           m_stack.before(lifted.pixel, lifted.depth, index).transmittance < 0.5f ||
           m_stack.haloed(lifted.pixel, lifted.depth, index) ||
           m_stack.inked(lifted.pixel, lifted.depth, index);
  }

  const InkFrame& m_in;
  LayerStack m_stack;
  LinePops& m_pops;
};

}  // namespace

LinePops popsBetween(const InkFrame& before, const InkFrame& now) {
  LinePops pops;
  Search forwards(now, pops);
  Search backwards(before, pops);
  for (std::size_t i = 0; i < before.structures.size(); ++i) {
    forwards.add(before.structures[i], i);
    backwards.add(now.structures[i], i);
  }
  return pops;
}

}  // namespace sline::render
