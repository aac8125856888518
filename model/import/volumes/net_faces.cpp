// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/net_faces.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace sline::model {

namespace {

struct VoxelEdge {
  std::uint16_t start;
  std::uint16_t end;
};

/// The labels at both ends of the edge that begins at the cell's first corner.
VoxelEdge edgeAt(const VoxelBox& box, const SurfaceNet::Cell& cell, unsigned axis) {
  return {box.label(cell.x, cell.y, cell.z),
          box.label(cell.x + (axis == 0), cell.y + (axis == 1), cell.z + (axis == 2))};
}

/// Calls visit(face, label) for both structures at each edge whose ends differ; background is none.
template <class Visit>
void forFaces(const VoxelBox& box, const SurfaceNet& net, const Visit& visit) {
  for (std::uint32_t i = 0; i < net.cells.size(); ++i)
    for (unsigned axis = 0; axis < 3; ++axis) {
      const VoxelEdge edge = edgeAt(box, net.cells[i], axis);
      if (edge.start == edge.end)
        continue;
      if (edge.start != 0)
        visit(8 * i + 2 * axis, edge.start);
      if (edge.end != 0)
        visit(8 * i + 2 * axis + 1, edge.end);
    }
}

}  // namespace

/// Builds one structure's mesh. Vertices have keys while it grows: 16 × cell + n, where n < 4 is a
/// sheet in the cell; 4 … 9 is the middle of the link to the cell beside it along an axis; 10 … 12
/// the middle of a face.
class LabelMesher {
 public:
  LabelMesher(const NetFaces& faces, std::size_t label, std::span<const glm::vec3> at)
      : m_faces(faces), m_net(faces.m_net), m_label(std::uint16_t(label)), m_at(at) {}

  NetFaces::LabelMesh build() {
    const std::size_t begin = m_faces.m_first[m_label - 1u];
    const std::size_t end = m_faces.m_first[m_label];
    m_triangles.reserve(2 * (end - begin));
    for (std::size_t i = begin; i < end; ++i)
      addFace(m_faces.m_faces[i]);
    std::vector<std::uint32_t> keys;
    keys.reserve(3 * m_triangles.size());
    for (const Triangle& t : m_triangles)
      keys.insert(keys.end(), t.begin(), t.end());
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    for (Triangle& t : m_triangles)
      for (std::uint32_t& key : t)
        key = std::uint32_t(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
    NetFaces::LabelMesh mesh;
    mesh.triangles = std::move(m_triangles);
    for (const std::uint32_t key : keys) {
      mesh.cells.push_back(key / 16);
      mesh.positions.push_back(place(key));
    }
    return mesh;
  }

 private:
  /// A corner of a face: its cell, which of the cell's corners are the structure's, and which of
  /// its edges the face lies across.
  struct Corner {
    std::uint32_t cell = 0;
    unsigned corners = 0;
    unsigned edge = 0;
    std::uint32_t key = 0;
  };

  unsigned cornersOf(std::uint32_t cell) const {
    const SurfaceNet::Cell& c = m_net.cells[cell];
    unsigned corners = 0;
    for (unsigned i = 0; i < 8; ++i)
      if (m_faces.m_box.label(c.x + int(i & 1u), c.y + int(i >> 1 & 1u), c.z + int(i >> 2)) ==
          m_label)
        corners |= 1u << i;
    return corners;
  }

  Corner corner(std::uint32_t cell, unsigned edge) const {
    const unsigned corners = cornersOf(cell);
    return {cell, corners, edge, 16 * cell + m_faces.m_cycles.cycleOf(corners, edge)};
  }

  void addFace(NetFaces::Face face) {
    const std::uint32_t far = face / 8;
    const unsigned axis = face % 8 / 2;
    const unsigned b = (axis + 1) % 3;
    const unsigned c = (axis + 2) % 3;
    const std::uint32_t nearB = m_net.neighbours[far][2 * b];
    const std::uint32_t nearC = m_net.neighbours[far][2 * c];
    const std::uint32_t near = m_net.neighbours[nearB][2 * c];
    // Counter-clockwise seen from the edge's end, which is outside if the structure is at its
    // start.
    std::array<Corner, 4> corners = {
        corner(near, CellCycles::edge(axis, 1, 1)), corner(nearC, CellCycles::edge(axis, 0, 1)),
        corner(far, CellCycles::edge(axis, 0, 0)), corner(nearB, CellCycles::edge(axis, 1, 0))};
    const bool atEnd = face % 2 != 0;
    if (atEnd)
      std::swap(corners[1], corners[3]);
    std::array<std::uint32_t, 4> middles{};
    bool split = false;
    for (std::size_t i = 0; i < 4; ++i) {
      middles[i] = middleOf(corners[i], corners[(i + 1) % 4], atEnd);
      split = split || middles[i] != SurfaceNet::none;
    }
    // All structures cut a face along the same diagonal, the shorter one.
    const bool even = length(corners[0], corners[2]) <= length(corners[1], corners[3]);
    const std::size_t first = even ? 0 : 1;
    if (!split) {
      const std::uint32_t a = corners[first].key;
      const std::uint32_t d = corners[first + 2].key;
      m_triangles.push_back({a, corners[first + 1].key, d});
      m_triangles.push_back({a, d, corners[(first + 3) % 4].key});
      return;
    }
    const std::uint32_t middle = 16 * far + 10 + axis;
    m_extra.push_back({middle, corners[first].cell, corners[first + 2].cell});
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t next = corners[(i + 1) % 4].key;
      if (middles[i] == SurfaceNet::none) {
        m_triangles.push_back({middle, corners[i].key, next});
      } else {
        m_triangles.push_back({middle, corners[i].key, middles[i]});
        m_triangles.push_back({middle, middles[i], next});
      }
    }
  }

  float length(const Corner& a, const Corner& b) const {
    const glm::vec3 d = m_at[a.cell] - m_at[b.cell];
    return glm::dot(d, d);
  }

  /// Two sheets may run through the same two cells and, because each is one vertex there, share the
  /// link between them: such a link gets a vertex in its middle for each sheet.
  std::uint32_t middleOf(const Corner& a, const Corner& b, bool atEnd) {
    unsigned side = 0;
    while (m_net.neighbours[a.cell][side] != b.cell)
      ++side;
    const bool ahead = side % 2 != 0;
    const Corner& low = ahead ? a : b;
    const Corner& high = ahead ? b : a;
    const unsigned axis = side / 2;
    const unsigned lowFace = 2 * axis + 1;
    if (!CellCycles::isDiagonal(low.corners, lowFace) || !oneSheet(low.corners, lowFace) ||
        !oneSheet(high.corners, 2 * axis))
      return SurfaceNet::none;
    // The two sheets are told apart by the corner of the structure at which they turn.
    const unsigned inside = CellCycles::edgeStart(low.edge) | (atEnd ? 1u << low.edge / 4 : 0u);
    const bool second = (inside >> (axis + 1) % 3 & 1u) != 0;
    const std::uint32_t key = 16 * low.cell + 4 + 2 * axis + (second ? 1 : 0);
    m_extra.push_back({key, low.cell, high.cell});
    return key;
  }

  /// True where both turns around a diagonal face belong to the same sheet.
  bool oneSheet(unsigned corners, unsigned face) const {
    std::array<std::uint8_t, 2> sheets{};
    std::size_t count = 0;
    for (const unsigned corner : CellCycles::faceCorners(face))
      if ((corners >> corner & 1u) != 0)
        sheets[count++] = m_faces.m_cycles.cycleOf(corners, CellCycles::edgeInFace(face, corner));
    return sheets[0] == sheets[1];
  }

  glm::vec3 place(std::uint32_t key) {
    if (key % 16 < 4)
      return m_at[key / 16];
    if (!m_sorted)
      std::sort(m_extra.begin(), m_extra.end(),
                [](const Middle& a, const Middle& b) { return a.key < b.key; });
    m_sorted = true;
    const auto found =
        std::lower_bound(m_extra.begin(), m_extra.end(), key,
                         [](const Middle& middle, std::uint32_t k) { return middle.key < k; });
    return 0.5f * (m_at[found->from] + m_at[found->to]);
  }

  struct Middle {
    std::uint32_t key;
    std::uint32_t from;
    std::uint32_t to;
  };

  const NetFaces& m_faces;
  const SurfaceNet& m_net;
  std::uint16_t m_label;
  std::span<const glm::vec3> m_at;
  std::vector<Triangle> m_triangles;  ///< of keys
  std::vector<Middle> m_extra;
  bool m_sorted = false;
};

NetFaces::NetFaces(const VoxelBox& box, const SurfaceNet& net, std::size_t labels)
    : m_box(box), m_net(net), m_first(labels + 2, 0) {
  forFaces(box, net, [this](Face, std::uint16_t label) { ++m_first[label + 1u]; });
  for (std::size_t i = 1; i < m_first.size(); ++i)
    m_first[i] += m_first[i - 1];
  m_faces.resize(m_first.back());
  // Each structure's beginning walks to its end, where the next one begins.
  forFaces(box, net, [this](Face face, std::uint16_t label) { m_faces[m_first[label]++] = face; });
}

NetFaces::LabelMesh NetFaces::mesh(std::size_t label, std::span<const glm::vec3> at) const {
  return LabelMesher(*this, label, at).build();
}

}  // namespace sline::model
