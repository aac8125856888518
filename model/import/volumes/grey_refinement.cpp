// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/grey_refinement.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

constexpr std::size_t fewVoxels = std::size_t(1) << 23;
constexpr std::size_t mostVoxels = std::size_t(1) << 26;
constexpr double mostOblong = 1.6;

/// Interpolates, but never goes beyond both neighbours: at the edge to air a cubic swings over as
/// far as bone.
std::int16_t between(int a, int b, int c, int d) {
  const int sum = 9 * (b + c) - a - d;
  return std::int16_t(std::clamp((sum + (sum < 0 ? -8 : 8)) / 16, std::min(b, c), std::max(b, c)));
}

void doubleAlong(GreyVolume& volume, int axis) {
  const glm::ivec3 before = volume.size;
  const int count = before[axis];
  glm::ivec3 size = before;
  size[axis] = 2 * count - 1;
  const auto stride = [axis](const glm::ivec3& of) {
    const std::array<std::size_t, 3> all{1, std::size_t(of.x),
                                         std::size_t(of.x) * std::size_t(of.y)};
    return all[std::size_t(axis)];
  };
  const std::size_t from = stride(before);
  const std::size_t lines = volume.voxels.size() / std::size_t(count);
  std::vector<std::int16_t> finer(lines * std::size_t(size[axis]));
  // Lines along the axis begin at each voxel of the planes below it, block by block.
  parallelFor(lines, 256, [&](std::size_t line) {
    const std::size_t block = line / from;
    const std::size_t within = line % from;
    const std::int16_t* in = volume.voxels.data() + block * from * std::size_t(count) + within;
    std::int16_t* out = finer.data() + block * from * std::size_t(size[axis]) + within;
    const auto at = [&](int i) { return int(in[std::size_t(std::clamp(i, 0, count - 1)) * from]); };
    for (int i = 0; i < count; ++i) {
      out[std::size_t(2 * i) * from] = std::int16_t(at(i));
      if (i + 1 < count)
        out[std::size_t(2 * i + 1) * from] = between(at(i - 1), at(i), at(i + 1), at(i + 2));
    }
  });
  volume.voxels = std::move(finer);
  volume.size = size;
  volume.toLps[axis] *= 0.5;
}

double sideOf(const GreyVolume& volume, int axis) {
  return glm::length(glm::dvec3(volume.toLps[axis]));
}

/// Returns the axis to go on with, or −1.
int coarsest(const GreyVolume& volume) {
  int longest = 0;
  double shortest = sideOf(volume, 0);
  for (int axis = 1; axis < 3; ++axis) {
    if (sideOf(volume, axis) > sideOf(volume, longest))
      longest = axis;
    shortest = std::min(shortest, sideOf(volume, axis));
  }
  const bool oblong = sideOf(volume, longest) > mostOblong * shortest;
  const bool small = volume.voxels.size() <= fewVoxels;
  const bool finite = volume.size[longest] > 1 && volume.size[longest] < 8192;
  return (oblong || small) && finite && 2 * volume.voxels.size() <= mostVoxels ? longest : -1;
}

}  // namespace

std::optional<GreyVolume> refinedScan(const GreyVolume& volume) {
  constexpr int mostTimes = 6;
  std::optional<GreyVolume> finer;
  for (int i = 0; i < mostTimes; ++i) {
    const int axis = coarsest(finer ? *finer : volume);
    if (axis < 0)
      break;
    if (!finer)
      finer = volume;
    doubleAlong(*finer, axis);
  }
  return finer;
}

}  // namespace sline::model
