// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/voxel_pieces.h"

#include <algorithm>
#include <array>

#include "model/base/parallel.h"

namespace sline::model {

std::optional<VoxelPieces> VoxelPieces::find(const LabelVolume& mask, bool ofBackground,
                                             const std::function<bool()>& goesOn) {
  VoxelPieces pieces;
  pieces.m_background = ofBackground;
  if (!pieces.gather(mask, goesOn))
    return std::nullopt;
  const auto rows = std::size_t(mask.size.y);
  for (int z = 0; z < mask.size.z; ++z) {
    if (!goesOn())
      return std::nullopt;
    for (int y = 0; y < mask.size.y; ++y) {
      const std::size_t row = std::size_t(z) * rows + std::size_t(y);
      if (y > 0)
        pieces.joinRows(row, row - 1);
      if (z > 0)
        pieces.joinRows(row, row - rows);
    }
  }
  pieces.number();
  return pieces;
}

bool VoxelPieces::gather(const LabelVolume& mask, const std::function<bool()>& goesOn) {
  const std::size_t most = mask.voxels.size() / 3 + 1024;
  m_firstRun.reserve(std::size_t(mask.size.y) * std::size_t(mask.size.z) + 1);
  for (int z = 0; z < mask.size.z; ++z) {
    if (!goesOn() || m_runs.size() > most)
      return false;
    for (int y = 0; y < mask.size.y; ++y) {
      m_firstRun.push_back(m_runs.size());
      const std::uint16_t* row = mask.voxels.data() + mask.at(0, y, z);
      for (int x = 0; x < mask.size.x;) {
        const int begin = x;
        const bool set = row[x] != 0;
        while (x < mask.size.x && (row[x] != 0) == set)
          ++x;
        if (set != m_background)
          m_runs.push_back({begin, x, std::uint32_t(m_runs.size())});
      }
    }
  }
  m_firstRun.push_back(m_runs.size());
  return true;
}

std::uint32_t VoxelPieces::rootOf(std::uint32_t run) {
  while (m_runs[run].piece != run) {
    m_runs[run].piece = m_runs[m_runs[run].piece].piece;
    run = m_runs[run].piece;
  }
  return run;
}

void VoxelPieces::joinRows(std::size_t row, std::size_t other) {
  std::size_t a = m_firstRun[row];
  std::size_t b = m_firstRun[other];
  while (a < m_firstRun[row + 1] && b < m_firstRun[other + 1]) {
    const Run& mine = m_runs[a];
    const Run& its = m_runs[b];
    if (mine.begin < its.end && its.begin < mine.end) {
      const std::uint32_t first = rootOf(std::uint32_t(a));
      const std::uint32_t second = rootOf(std::uint32_t(b));
      m_runs[std::max(first, second)].piece = std::min(first, second);
    }
    if (m_runs[a].end < m_runs[b].end)
      ++a;
    else
      ++b;
  }
}

void VoxelPieces::number() {
  // A root stands before all runs that belong to it.
  for (std::uint32_t run = 0; run < m_runs.size(); ++run) {
    Run& own = m_runs[run];
    if (own.piece == run) {
      own.piece = std::uint32_t(m_sizes.size());
      m_sizes.push_back(0);
    } else {
      own.piece = m_runs[own.piece].piece;
    }
    m_sizes[own.piece] += std::uint64_t(own.end - own.begin);
  }
}

void VoxelPieces::invert(LabelVolume& mask, const std::vector<bool>& pieces) const {
  for (std::size_t row = 0; row + 1 < m_firstRun.size(); ++row)
    for (std::size_t i = m_firstRun[row]; i < m_firstRun[row + 1]; ++i)
      if (pieces[m_runs[i].piece]) {
        std::uint16_t* at = mask.voxels.data() + row * std::size_t(mask.size.x);
        std::fill(at + m_runs[i].begin, at + m_runs[i].end, std::uint16_t(m_background));
      }
}

void fillSlices(LabelVolume& mask, int axis) {
  const std::array<std::size_t, 3> stride{1, std::size_t(mask.size.x),
                                          std::size_t(mask.size.x) * std::size_t(mask.size.y)};
  const auto u = std::size_t((axis + 1) % 3);
  const auto v = std::size_t((axis + 2) % 3);
  const int width = mask.size[int(u)];
  const int height = mask.size[int(v)];
  parallelFor(std::size_t(mask.size[axis]), 1, [&](std::size_t slice) {
    std::uint16_t* begin = mask.voxels.data() + slice * stride[std::size_t(axis)];
    const auto voxel = [&](int x, int y) -> std::uint16_t& {
      return begin[std::size_t(x) * stride[u] + std::size_t(y) * stride[v]];
    };
    // The outside is everything that an edge of the slice leads to.
    std::vector<bool> outside(std::size_t(width) * std::size_t(height), false);
    std::vector<std::array<int, 2>> front;
    const auto reach = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= width || y >= height || voxel(x, y) != 0)
        return;
      const std::size_t at = std::size_t(y) * std::size_t(width) + std::size_t(x);
      if (!outside[at]) {
        outside[at] = true;
        front.push_back({x, y});
      }
    };
    for (int x = 0; x < width; ++x) {
      reach(x, 0);
      reach(x, height - 1);
    }
    for (int y = 0; y < height; ++y) {
      reach(0, y);
      reach(width - 1, y);
    }
    while (!front.empty()) {
      const auto [x, y] = front.back();
      front.pop_back();
      reach(x - 1, y);
      reach(x + 1, y);
      reach(x, y - 1);
      reach(x, y + 1);
    }
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (!outside[std::size_t(y) * std::size_t(width) + std::size_t(x)])
          voxel(x, y) = 1;
  });
}

}  // namespace sline::model
