// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/surface/lattice_mesh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>

#include "model/base/parallel.h"
#include "model/import/molecules/surface/lattice_cuts.h"

namespace sline::model {

namespace {

/// Number of cubes along the side of a block, which is worked on at a time.
constexpr int side = 8;
constexpr int points = side + 1;

struct Sample {
  LatticePoint point;
  FieldPoint field;
  bool inside() const { return field.value > 0.0; }
};

using BlockIndex = std::array<std::int32_t, 3>;

std::vector<BlockIndex> blocksOf(const ImplicitSolid& solid, double spacing) {
  const double size = spacing * side;
  std::vector<BlockIndex> blocks;
  for (const Box& box : solid.boxes()) {
    BlockIndex low{};
    BlockIndex high{};
    for (int a = 0; a < 3; ++a) {
      // The tetrahedra of a block reach half a cube below it.
      low[a] = std::int32_t(std::floor((double(box.low[a]) - spacing) / size));
      high[a] = std::int32_t(std::floor((double(box.high[a]) + spacing) / size));
    }
    for (BlockIndex b = low; b[2] <= high[2]; ++b[2])
      for (b[1] = low[1]; b[1] <= high[1]; ++b[1])
        for (b[0] = low[0]; b[0] <= high[0]; ++b[0])
          blocks.push_back(b);
  }
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

/// Samples the function in one block of cubes and cuts its tetrahedra.
class Block {
 public:
  Block(const ImplicitSolid& solid, const BlockIndex& index, double spacing)
      : m_index(index), m_half(0.5 * spacing) {
    Box box;
    for (int a = 0; a < 3; ++a) {
      box.low[a] = float(spacing * (double(index[a]) * side - 0.6));
      box.high[a] = float(spacing * (double(index[a]) * side + side + 0.1));
    }
    m_field = solid.within(box, spacing);
  }

  CutSurface cut() {
    if (!m_field)
      return {};
    sample();
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          cutCube({x, y, z});
    return std::move(m_surface);
  }

 private:
  glm::dvec3 placeOf(const LatticePoint& p) const {
    return {m_half * double(p.x), m_half * double(p.y), m_half * double(p.z)};
  }

  void sample() {
    bool some = false;
    bool all = true;
    for (int k = 0; k < 2; ++k)
      for (int z = 0; z < points; ++z)
        for (int y = 0; y < points; ++y)
          for (int x = 0; x < points; ++x) {
            Sample& s = at(k, x, y, z);
            // Corners have indices 0 … side, centres −1 … side − 1.
            s.point = {2 * (m_index[0] * side + x) - k, 2 * (m_index[1] * side + y) - k,
                       2 * (m_index[2] * side + z) - k};
            s.field = m_field->at(placeOf(s.point));
            some = some || s.inside();
            all = all && s.inside();
          }
    m_mixed = some && !all;
  }

  Sample& at(int kind, int x, int y, int z) {
    const std::size_t row = (std::size_t(kind) * points + std::size_t(z)) * points + std::size_t(y);
    return m_samples[row * points + std::size_t(x)];
  }

  /// Cuts the four tetrahedra around each edge between a cube's centre and that of its lower
  /// neighbour.
  void cutCube(const std::array<int, 3>& cube) {
    if (!m_mixed)
      return;
    static constexpr int ring[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Sample& centre = at(1, cube[0] + 1, cube[1] + 1, cube[2] + 1);
    for (int axis = 0; axis < 3; ++axis) {
      std::array<int, 3> below = {cube[0] + 1, cube[1] + 1, cube[2] + 1};
      --below[axis];
      const Sample& lower = at(1, below[0], below[1], below[2]);
      std::array<const Sample*, 4> corners{};
      for (int i = 0; i < 4; ++i) {
        std::array<int, 3> corner = cube;
        corner[(axis + 1) % 3] += ring[i][0];
        corner[(axis + 2) % 3] += ring[i][1];
        corners[i] = &at(0, corner[0], corner[1], corner[2]);
      }
      for (int i = 0; i < 4; ++i)
        cutTetrahedron({&lower, &centre, corners[i], corners[(i + 1) % 4]});
    }
  }

  /// Cuts a tetrahedron. `t` is positively oriented: (t1−t0)×(t2−t0) points to t3's side.
  void cutTetrahedron(const std::array<const Sample*, 4>& t) {
    int mask = 0;
    for (int i = 0; i < 4; ++i)
      mask |= t[i]->inside() ? 1 << i : 0;
    if (mask == 0 || mask == 15)
      return;
    // These even permutations bring the one or two corners on their own to the front.
    static constexpr int orders[16][4] = {{},           {0, 1, 2, 3}, {1, 0, 3, 2}, {0, 1, 2, 3},
                                          {2, 3, 0, 1}, {0, 2, 3, 1}, {1, 2, 0, 3}, {3, 2, 1, 0},
                                          {3, 2, 1, 0}, {0, 3, 1, 2}, {1, 3, 2, 0}, {2, 3, 0, 1},
                                          {2, 3, 0, 1}, {1, 0, 3, 2}, {0, 1, 2, 3}, {}};
    const int* o = orders[mask];
    const Sample& a = *t[o[0]];
    const Sample& b = *t[o[1]];
    const Sample& c = *t[o[2]];
    const Sample& d = *t[o[3]];
    const bool alone = a.inside() != b.inside();
    if (alone && a.inside()) {
      m_surface.triangles.push_back({cutOf(a, b), cutOf(a, c), cutOf(a, d)});
    } else if (alone) {
      m_surface.triangles.push_back({cutOf(b, a), cutOf(d, a), cutOf(c, a)});
    } else {
      const std::uint32_t ac = cutOf(a, c);
      const std::uint32_t bd = cutOf(b, d);
      m_surface.triangles.push_back({ac, cutOf(a, d), bd});
      m_surface.triangles.push_back({ac, bd, cutOf(b, c)});
    }
  }

  std::uint32_t cutOf(const Sample& in, const Sample& out) {
    const auto wanted = [&](const auto& known) {
      return known.first == &in && known.second == &out;
    };
    // A cut is asked for again by the tetrahedra that follow, seldom later.
    const std::size_t memory = std::min<std::size_t>(m_recent.size(), 24);
    for (std::size_t i = m_recent.size() - memory; i < m_recent.size(); ++i)
      if (wanted(m_recent[i]))
        return std::uint32_t(i);
    m_recent.emplace_back(&in, &out);
    const double share = in.field.value / (in.field.value - out.field.value);
    const glm::dvec3 from = placeOf(in.point);
    const glm::dvec3 crossing = from + share * (placeOf(out.point) - from);
    m_surface.cuts.push_back({in.point, out.point, float(share),
                              glm::vec3(m_field->at(crossing).onSurface),
                              glm::vec3(in.field.onSurface), glm::vec3(out.field.onSurface)});
    return std::uint32_t(m_surface.cuts.size() - 1);
  }

  BlockIndex m_index;
  double m_half;
  std::unique_ptr<LocalField> m_field;
  bool m_mixed = false;
  std::array<Sample, std::size_t(2) * points * points * points> m_samples;
  std::vector<std::pair<const Sample*, const Sample*>> m_recent;
  CutSurface m_surface;
};

}  // namespace

TriangleMesh latticeMesh(const ImplicitSolid& solid, double spacing,
                         const std::function<bool()>& goesOn) {
  const std::vector<BlockIndex> blocks = blocksOf(solid, spacing);
  std::vector<CutSurface> cut(blocks.size());
  std::atomic<bool> stopped = false;
  parallelFor(blocks.size(), 4, [&](std::size_t i) {
    if (stopped || (i % 64 == 0 && !goesOn())) {
      stopped = true;
      return;
    }
    cut[i] = std::make_unique<Block>(solid, blocks[i], spacing)->cut();
  });
  if (stopped)
    return {};
  CutSurface whole;
  for (CutSurface& one : cut) {
    const auto first = std::uint32_t(whole.cuts.size());
    whole.cuts.insert(whole.cuts.end(), one.cuts.begin(), one.cuts.end());
    for (const Triangle& t : one.triangles)
      whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    one = {};
  }
  return meshOf(std::move(whole));
}

}  // namespace sline::model
