// SPDX-License-Identifier: Apache-2.0
// A lattice of places on which balls are rolled over atoms.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "model/geometry/atom_set.h"

namespace sline::model {

/// Places lie at whole multiples of the step, so that grids of one step agree wherever they begin.
struct ProbeGrid {
  glm::ivec3 first{0};  ///< of the first place, in steps
  glm::ivec3 size{0};   ///< places along each axis
  double step = 0.5;    ///< mm

  std::size_t count() const {
    return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  }
  std::uint32_t index(const glm::ivec3& cell) const {
    return std::uint32_t((std::size_t(cell.z) * std::size_t(size.y) + std::size_t(cell.y)) *
                             std::size_t(size.x) +
                         std::size_t(cell.x));
  }
  glm::ivec3 cell(std::uint32_t index) const {
    const auto x = std::uint32_t(size.x);
    const auto y = std::uint32_t(size.y);
    return {int(index % x), int(index / x % y), int(index / x / y)};
  }
  bool holds(const glm::ivec3& cell) const {
    return cell.x >= 0 && cell.y >= 0 && cell.z >= 0 && cell.x < size.x && cell.y < size.y &&
           cell.z < size.z;
  }
  glm::dvec3 place(const glm::ivec3& cell) const { return step * glm::dvec3(first + cell); }
  /// Returns the cell around a place, which may lie outside the grid.
  glm::ivec3 cellAt(const glm::dvec3& place) const {
    return glm::ivec3(glm::floor(place / step + 0.5)) - first;
  }
};

/// Returns false where the work is not wanted any more.
using GoesOn = std::function<bool()>;

/// Returns the grid around the atoms and `margin` mm more, its step as much coarser than wanted as
/// it takes to have no more places than `mostPlaces`; nothing where not even `coarsest` is enough.
struct GridWish {
  double margin = 0.0;
  double step = 0.5;
  double coarsest = 1.5;
  std::size_t mostPlaces = std::size_t(16) << 20;
};
std::optional<ProbeGrid> gridAround(std::span<const AtomBall> atoms, const GridWish& wish);

/// Returns for each place how far it lies outside the nearest atom's ball, mm, negative within;
/// `reach` where it is more. Nothing once the work is not wanted any more.
std::optional<std::vector<float>> atomDistances(const ProbeGrid& grid,
                                                std::span<const AtomBall> atoms, float reach,
                                                const GoesOn& goesOn);

inline constexpr std::uint32_t noPlace = 0xffffffffu;
/// Replaces each place's number by that of the nearest place that has its own number; `noPlace`
/// where there is none at all. Exact, in time that grows with the number of places alone
/// (Felzenszwalb & Huttenlocher, "Distance Transforms of Sampled Functions", Theory of Computing 8,
/// 2012). Returns false once the work is not wanted any more.
bool spreadToNearest(const ProbeGrid& grid, std::vector<std::uint32_t>& nearest,
                     const GoesOn& goesOn);

/// Returns the distance between two places, mm.
double distanceBetween(const ProbeGrid& grid, std::uint32_t a, std::uint32_t b);

}  // namespace sline::model
