// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/label_mesh.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>

namespace sline::model {

namespace {

class Mesher {
 public:
  Mesher(const VoxelBox& box, const SurfaceNet& net, const LabelSheets& sheets,
         std::span<const glm::vec3> at)
      : m_box(box), m_net(net), m_sheets(sheets), m_at(at) {}

  LabelMesh build(std::size_t label) {
    m_label = std::uint16_t(label);
    const std::span<const LabelSheets::Quad> quads = m_sheets.quadsOf(label);
    m_nodes.reserve(4 * quads.size());
    for (const LabelSheets::Quad& quad : quads)
      m_nodes.insert(m_nodes.end(), quad.nodes.begin(), quad.nodes.end());
    std::sort(m_nodes.begin(), m_nodes.end());
    m_nodes.erase(std::unique(m_nodes.begin(), m_nodes.end()), m_nodes.end());
    for (const std::uint32_t node : m_nodes) {
      m_mesh.points.push_back(m_sheets.pointOf[node]);
      m_mesh.positions.push_back(place(node));
    }
    m_mesh.triangles.reserve(2 * quads.size());
    for (const LabelSheets::Quad& quad : quads)
      addQuad(quad);
    return std::move(m_mesh);
  }

 private:
  static constexpr std::uint32_t none = SurfaceNet::none;

  const glm::vec3& place(std::uint32_t node) const { return m_at[m_sheets.pointOf[node]]; }
  std::uint32_t cell(std::uint32_t node) const { return m_sheets.cellOf[m_sheets.pointOf[node]]; }
  std::uint32_t vertex(std::uint32_t node) const {
    return std::uint32_t(std::lower_bound(m_nodes.begin(), m_nodes.end(), node) - m_nodes.begin());
  }
  float length(std::uint32_t a, std::uint32_t b) const {
    const glm::vec3 d = place(a) - place(b);
    return glm::dot(d, d);
  }

  void addQuad(const LabelSheets::Quad& quad) {
    const std::array<std::uint32_t, 4>& nodes = quad.nodes;
    std::array<std::uint32_t, 4> corners{};
    std::array<std::uint32_t, 4> middles{};
    bool split = false;
    for (std::size_t i = 0; i < 4; ++i) {
      corners[i] = vertex(nodes[i]);
      middles[i] = isTwice(nodes[i], nodes[(i + 1) % 4])
                       ? middle(quad.face, nodes[i], nodes[(i + 1) % 4])
                       : none;
      split = split || middles[i] != none;
    }
    // Both structures at a face cut it along the same diagonal, the shorter one.
    const std::size_t first = length(nodes[0], nodes[2]) <= length(nodes[1], nodes[3]) ? 0 : 1;
    const std::size_t across = first + 2;
    std::vector<Triangle>& triangles = m_mesh.triangles;
    if (!split) {
      triangles.push_back({corners[first], corners[first + 1], corners[across]});
      triangles.push_back({corners[first], corners[across], corners[(first + 3) % 4]});
      return;
    }
    const auto centre = std::uint32_t(m_mesh.positions.size());
    m_mesh.positions.push_back(0.5f * (place(nodes[first]) + place(nodes[across])));
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t next = corners[(i + 1) % 4];
      if (middles[i] == none) {
        triangles.push_back({centre, corners[i], next});
      } else {
        triangles.push_back({centre, corners[i], middles[i]});
        triangles.push_back({centre, middles[i], next});
      }
    }
  }

  /// Tells whether an edge occurs twice: two sheets may run through the same two cells and be one
  /// node in each.
  bool isTwice(std::uint32_t a, std::uint32_t b) const {
    const std::span<const LabelSheets::Side> sides = m_sheets.sidesOf(a);
    return sides.size() > 4 && std::count_if(sides.begin(), sides.end(),
                                             [b](const auto& side) { return side.next == b; }) > 1;
  }

  /// Returns the vertex between two nodes on the sheet of the face. The sheets are told apart by
  /// the voxel at which they turn, one of those that are parted in the face between the two cells.
  std::uint32_t middle(std::uint32_t face, std::uint32_t a, std::uint32_t b) {
    unsigned side = 0;
    while (m_net.neighbours[cell(a)][side] != cell(b))
      ++side;
    const unsigned axis = side / 2;
    const std::uint32_t low = side % 2 != 0 ? cell(a) : cell(b);
    const SurfaceNet::Cell& lowCell = m_net.cells[low];
    const SurfaceNet::Cell& far = m_net.cells[face / 8];
    glm::ivec3 voxel(far.x, far.y, far.z);
    if ((face % 2 != 0) != higherParted(lowCell, axis))
      ++voxel[int(face % 8 / 2)];
    const glm::ivec3 corner(lowCell.x, lowCell.y, lowCell.z);
    const auto beside = int((axis + 1) % 3);
    const bool second = voxel[beside] != corner[beside];
    const auto [found, fresh] = m_middles.try_emplace(
        std::array<std::uint32_t, 2>{low, 2 * axis + (second ? 1 : 0)}, m_mesh.positions.size());
    if (fresh)
      m_mesh.positions.push_back(0.5f * (place(a) + place(b)));
    return std::uint32_t(found->second);
  }

  /// Returns true where, in the diagonal face behind the cell along the axis, not the structure's
  /// voxels are parted but those of the higher label at the other two corners.
  bool higherParted(const SurfaceNet::Cell& low, unsigned axis) const {
    std::array<std::uint16_t, 4> others{};
    std::size_t count = 0;
    for (int i = 0; i < 4; ++i) {
      glm::ivec3 voxel(low.x, low.y, low.z);
      ++voxel[int(axis)];
      voxel[int((axis + 1) % 3)] += i & 1;
      voxel[int((axis + 2) % 3)] += i >> 1;
      const std::uint16_t label = m_box.label(voxel.x, voxel.y, voxel.z);
      if (label != m_label)
        others[count++] = label;
    }
    return others[0] == others[1] && others[0] > m_label;
  }

  const VoxelBox& m_box;
  const SurfaceNet& m_net;
  const LabelSheets& m_sheets;
  std::span<const glm::vec3> m_at;
  std::uint16_t m_label = 0;
  std::vector<std::uint32_t> m_nodes;
  std::map<std::array<std::uint32_t, 2>, std::size_t> m_middles;
  LabelMesh m_mesh;
};

}  // namespace

LabelMesh labelMesh(const VoxelBox& box, const SurfaceNet& net, const LabelSheets& sheets,
                    std::size_t label, std::span<const glm::vec3> at) {
  return Mesher(box, net, sheets, at).build(label);
}

}  // namespace sline::model
