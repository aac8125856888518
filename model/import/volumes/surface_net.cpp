// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/surface_net.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>

#include "model/base/parallel.h"

namespace sline::model {

namespace {

using Corners = std::array<std::uint16_t, 8>;

bool uniform(const Corners& c, std::size_t a, std::size_t b, std::size_t d, std::size_t e) {
  return c[a] == c[b] && c[a] == c[d] && c[a] == c[e];
}

/// Returns a mask in which bit n says that the surface crosses face n.
unsigned crossedFaces(const Corners& c) {
  return unsigned(!uniform(c, 0, 2, 4, 6)) | unsigned(!uniform(c, 1, 3, 5, 7)) << 1 |
         unsigned(!uniform(c, 0, 1, 4, 5)) << 2 | unsigned(!uniform(c, 2, 3, 6, 7)) << 3 |
         unsigned(!uniform(c, 0, 1, 2, 3)) << 4 | unsigned(!uniform(c, 4, 5, 6, 7)) << 5;
}

/// Calls visit(x, corners) for each cell of a row in which labels differ.
template <class Visit>
void visitRow(const VoxelBox& box, int y, int z, const Visit& visit) {
  const std::array<const std::uint16_t*, 4> rows = {box.row(y, z), box.row(y + 1, z),
                                                    box.row(y, z + 1), box.row(y + 1, z + 1)};
  if (!rows[0] && !rows[1] && !rows[2] && !rows[3])
    return;
  const int width = box.cells().x;
  Corners c{};
  for (int x = 0; x < width; ++x) {
    for (std::size_t i = 0; i < 4; ++i)
      c[2 * i + 1] = rows[i] && x + 1 < width ? rows[i][x] : std::uint16_t(0);
    if (c[0] != c[1] || !uniform(c, 0, 2, 4, 6) || !uniform(c, 1, 3, 5, 7))
      visit(x, c);
    for (std::size_t i = 0; i < 4; ++i)
      c[2 * i] = c[2 * i + 1];
  }
}

SurfaceNet::Cell cellWith(int x, int y, int z, const Corners& c) {
  SurfaceNet::Cell cell{std::uint16_t(x), std::uint16_t(y), std::uint16_t(z)};
  const auto [low, high] = std::minmax_element(c.begin(), c.end());
  cell.background = *low == 0;
  for (unsigned i = 0; i < 8; ++i) {
    cell.junction = cell.junction || (c[i] != *low && c[i] != *high);
    if (c[i] == *high)
      cell.corners = std::uint8_t(cell.corners | 1u << i);
  }
  return cell;
}

class NetBuilder {
 public:
  NetBuilder(const VoxelBox& box, const std::function<bool()>& goesOn)
      : m_box(box), m_goesOn(goesOn), m_size(box.cells()) {}

  std::optional<SurfaceNet> build(std::uint64_t mostCells) {
    m_first.assign(std::size_t(m_size.y) * std::size_t(m_size.z) + 1, 0);
    forRows([this](std::size_t row, int y, int z) {
      visitRow(m_box, y, z, [&](int, const Corners&) { ++m_first[row + 1]; });
    });
    std::uint64_t count = 0;
    for (std::uint32_t& first : m_first) {
      count += first;
      if (count > std::min<std::uint64_t>(mostCells, 1u << 28))
        return std::nullopt;
      first = std::uint32_t(count);
    }
    if (m_stopped)
      return std::nullopt;
    m_net.cells.resize(count);
    m_net.neighbours.resize(count);
    m_crossed.resize(count);
    forRows([this](std::size_t row, int y, int z) {
      std::uint32_t at = m_first[row];
      visitRow(m_box, y, z, [&](int x, const Corners& c) {
        m_net.cells[at] = cellWith(x, y, z, c);
        m_crossed[at++] = std::uint8_t(crossedFaces(c));
      });
    });
    forRows([this](std::size_t row, int, int) { link(row); });
    if (m_stopped)
      return std::nullopt;
    return std::move(m_net);
  }

 private:
  template <class Body>
  void forRows(const Body& body) {
    parallelFor(std::size_t(m_size.z), 1, [&](std::size_t z) {
      if (m_stopped || !m_goesOn()) {
        m_stopped = true;
        return;
      }
      for (int y = 0; y < m_size.y; ++y)
        body(z * std::size_t(m_size.y) + std::size_t(y), y, int(z));
    });
  }

  /// Returns the cell at x in the row; it is there because the surface crosses the face towards it.
  std::uint32_t find(std::size_t row, std::uint16_t x) const {
    const auto begin = m_net.cells.begin() + m_first[row];
    const auto end = m_net.cells.begin() + m_first[row + 1];
    const auto found = std::lower_bound(
        begin, end, x, [](const SurfaceNet::Cell& cell, std::uint16_t at) { return cell.x < at; });
    return std::uint32_t(found - m_net.cells.begin());
  }

  void link(std::size_t row) {
    const auto slice = std::size_t(m_size.y);
    for (std::uint32_t i = m_first[row]; i < m_first[row + 1]; ++i) {
      const unsigned crossed = m_crossed[i];
      const std::uint16_t x = m_net.cells[i].x;
      const auto to = [&](unsigned face, auto cell) {
        m_net.neighbours[i][face] = (crossed >> face & 1u) != 0 ? cell() : SurfaceNet::none;
      };
      to(0, [&] { return i - 1; });
      to(1, [&] { return i + 1; });
      to(2, [&] { return find(row - 1, x); });
      to(3, [&] { return find(row + 1, x); });
      to(4, [&] { return find(row - slice, x); });
      to(5, [&] { return find(row + slice, x); });
    }
  }

  const VoxelBox& m_box;
  const std::function<bool()>& m_goesOn;
  glm::ivec3 m_size;
  std::atomic<bool> m_stopped = false;
  std::vector<std::uint32_t> m_first;  ///< start of each row's cells, and one more
  std::vector<std::uint8_t> m_crossed;
  SurfaceNet m_net;
};

}  // namespace

VoxelBox::VoxelBox(const LabelVolume& volume) : m_volume(volume) {
  glm::ivec3 low(std::numeric_limits<int>::max());
  glm::ivec3 high(-1);
  std::mutex mutex;
  parallelFor(std::size_t(volume.size.z), 1, [&](std::size_t slice) {
    const int z = int(slice);
    glm::ivec3 lowHere(std::numeric_limits<int>::max());
    glm::ivec3 highHere(-1);
    for (int y = 0; y < volume.size.y; ++y) {
      const std::uint16_t* row = volume.voxels.data() + volume.at(0, y, z);
      const std::uint16_t* end = row + volume.size.x;
      const auto taken = [](std::uint16_t label) { return label != 0; };
      const std::uint16_t* first = std::find_if(row, end, taken);
      if (first == end)
        continue;
      const auto last =
          std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), taken);
      lowHere = glm::min(lowHere, glm::ivec3(int(first - row), y, z));
      highHere = glm::max(highHere, glm::ivec3(int(last.base() - row) - 1, y, z));
    }
    const std::lock_guard lock(mutex);
    low = glm::min(low, lowHere);
    high = glm::max(high, highHere);
  });
  if (high.x < 0)
    return;
  m_low = low;
  m_size = high - low + 1;
}

std::optional<SurfaceNet> surfaceNet(const VoxelBox& box, std::uint64_t mostCells,
                                     const std::function<bool()>& goesOn) {
  return NetBuilder(box, goesOn).build(mostCells);
}

}  // namespace sline::model
