// SPDX-License-Identifier: Apache-2.0
#include "model/pockets/probe_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

/// Finds, along one line of places, the nearest of the places kept by each: the lower envelope of
/// parabolas over the line.
class LineSpread {
 public:
  LineSpread(const ProbeGrid& grid, int axis)
      : m_grid(grid),
        m_axis(axis),
        m_sites(std::size_t(grid.size[axis])),
        m_bounds(std::size_t(grid.size[axis]) + 1),
        m_heights(std::size_t(grid.size[axis])),
        m_kept(std::size_t(grid.size[axis])) {}

  void run(glm::ivec3 cell, std::vector<std::uint32_t>& nearest) {
    const int count = m_grid.size[m_axis];
    int last = -1;
    for (int i = 0; i < count; ++i) {
      cell[m_axis] = i;
      const std::uint32_t kept = nearest[m_grid.index(cell)];
      m_kept[std::size_t(i)] = kept;
      if (kept == noPlace)
        continue;
      const glm::dvec3 off(m_grid.cell(kept) - cell);
      m_heights[std::size_t(i)] = glm::dot(off, off);
      last = push(i, last);
    }
    if (last < 0)
      return;
    int site = 0;
    for (int i = 0; i < count; ++i) {
      while (site < last && m_bounds[std::size_t(site) + 1] < double(i))
        ++site;
      cell[m_axis] = i;
      nearest[m_grid.index(cell)] = m_kept[std::size_t(m_sites[std::size_t(site)])];
    }
  }

 private:
  /// Adds the parabola at i, and returns the number of the last one that remains.
  int push(int i, int last) {
    double from = -std::numeric_limits<double>::infinity();
    while (last >= 0) {
      const int before = m_sites[std::size_t(last)];
      from = (m_heights[std::size_t(i)] + double(i) * i - m_heights[std::size_t(before)] -
              double(before) * before) /
             (2.0 * (i - before));
      if (from > m_bounds[std::size_t(last)])
        break;
      --last;
    }
    if (last < 0)
      from = -std::numeric_limits<double>::infinity();
    ++last;
    m_sites[std::size_t(last)] = i;
    m_bounds[std::size_t(last)] = from;
    return last;
  }

  const ProbeGrid& m_grid;
  int m_axis;
  std::vector<int> m_sites;
  std::vector<double> m_bounds;   ///< where each site's parabola begins to be the lowest
  std::vector<double> m_heights;  ///< the squared distance to the kept place
  std::vector<std::uint32_t> m_kept;
};

}  // namespace

std::optional<ProbeGrid> gridAround(std::span<const AtomBall> atoms, const GridWish& wish) {
  if (atoms.empty())
    return std::nullopt;
  glm::dvec3 low(std::numeric_limits<double>::infinity());
  glm::dvec3 high(-low);
  for (const AtomBall& atom : atoms) {
    const double reach = double(atom.radius) + wish.margin;
    low = glm::min(low, glm::dvec3(atom.place) - reach);
    high = glm::max(high, glm::dvec3(atom.place) + reach);
  }
  const glm::dvec3 extent = high - low;
  for (double step = wish.step; step <= wish.coarsest; step *= 1.05) {
    const glm::dvec3 places = glm::ceil(extent / step) + 2.0;
    if (!(places.x * places.y * places.z <= double(wish.mostPlaces)))
      continue;
    return ProbeGrid{
        .first = glm::ivec3(glm::floor(low / step)), .size = glm::ivec3(places), .step = step};
  }
  return std::nullopt;
}

std::optional<std::vector<float>> atomDistances(const ProbeGrid& grid,
                                                std::span<const AtomBall> atoms, float reach,
                                                const GoesOn& goesOn) {
  std::vector<float> distances(grid.count(), reach);
  // Each layer of places takes the atoms near it, so that no two threads write to one place.
  std::vector<std::vector<std::uint32_t>> atomsOfLayer(std::size_t(grid.size.z));
  for (std::uint32_t i = 0; i < atoms.size(); ++i) {
    const glm::dvec3 own(atoms[i].place);
    const glm::dvec3 far(0.0, 0.0, double(atoms[i].radius + reach));
    const int low = std::max(grid.cellAt(own - far).z, 0);
    const int high = std::min(grid.cellAt(own + far).z, grid.size.z - 1);
    for (int z = low; z <= high; ++z)
      atomsOfLayer[std::size_t(z)].push_back(i);
  }
  std::atomic<bool> stopped = false;
  parallelFor(atomsOfLayer.size(), 1, [&](std::size_t z) {
    if (stopped || !goesOn()) {
      stopped = true;
      return;
    }
    for (const std::uint32_t i : atomsOfLayer[z]) {
      const glm::dvec3 own(atoms[i].place);
      const double far = double(atoms[i].radius + reach);
      const double dz = double(grid.first.z + int(z)) * grid.step - own.z;
      const double half = std::sqrt(std::max(far * far - dz * dz, 0.0));
      const glm::ivec3 low = glm::max(grid.cellAt(own - half), glm::ivec3(0));
      const glm::ivec3 high = glm::min(grid.cellAt(own + half), grid.size - 1);
      for (int y = low.y; y <= high.y; ++y) {
        const double dy = double(grid.first.y + y) * grid.step - own.y;
        float* row = &distances[grid.index({0, y, int(z)})];
        for (int x = low.x; x <= high.x; ++x) {
          const double dx = double(grid.first.x + x) * grid.step - own.x;
          const auto d = float(std::sqrt(dx * dx + dy * dy + dz * dz)) - atoms[i].radius;
          row[x] = std::min(row[x], d);
        }
      }
    }
  });
  if (stopped)
    return std::nullopt;
  return distances;
}

bool spreadToNearest(const ProbeGrid& grid, std::vector<std::uint32_t>& nearest,
                     const GoesOn& goesOn) {
  std::atomic<bool> stopped = false;
  for (int axis = 0; axis < 3; ++axis) {
    const int outer = axis == 2 ? 1 : 2;
    const int inner = axis == 0 ? 1 : 0;
    parallelFor(std::size_t(grid.size[outer]), 1, [&](std::size_t i) {
      if (stopped || !goesOn()) {
        stopped = true;
        return;
      }
      LineSpread line(grid, axis);
      glm::ivec3 cell(0);
      cell[outer] = int(i);
      for (int k = 0; k < grid.size[inner]; ++k) {
        cell[inner] = k;
        line.run(cell, nearest);
      }
    });
    if (stopped)
      return false;
  }
  return true;
}

double distanceBetween(const ProbeGrid& grid, std::uint32_t a, std::uint32_t b) {
  return grid.step * glm::length(glm::dvec3(grid.cell(a) - grid.cell(b)));
}

}  // namespace sline::model
