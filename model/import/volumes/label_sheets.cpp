// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/label_sheets.h"

#include <algorithm>

#include "model/base/parallel.h"
#include "model/import/volumes/cell_sheets.h"

namespace sline::model {

namespace {

constexpr std::size_t quadGrain = 8192;

/// Holds a cell's corners and the labels that stand there.
struct CellLabels {
  std::array<std::uint16_t, 8> corners{};
  std::array<std::uint16_t, 8> labels{};  ///< ascending, each once
  std::size_t count = 0;

  CellLabels(const VoxelBox& box, const SurfaceNet::Cell& cell) {
    for (unsigned i = 0; i < 8; ++i)
      corners[i] = box.label(cell.x + int(i & 1u), cell.y + int(i >> 1 & 1u), cell.z + int(i >> 2));
    labels = corners;
    std::sort(labels.begin(), labels.end());
    count = std::size_t(std::unique(labels.begin(), labels.end()) - labels.begin());
  }

  unsigned of(std::uint16_t label) const {
    unsigned bits = 0;
    for (unsigned i = 0; i < 8; ++i)
      bits |= unsigned(corners[i] == label) << i;
    return bits;
  }

  /// Returns the faces in which a higher label lies at both other corners of the label's diagonal.
  unsigned joined(std::uint16_t label, unsigned bits) const {
    unsigned faces = 0;
    for (unsigned face = 0; face < 6; ++face) {
      if (!isDiagonal(bits, face))
        continue;
      const std::array<unsigned, 4> around = faceCorners(face);
      const std::size_t other = corners[around[0]] == label ? 1 : 0;
      const std::uint16_t a = corners[around[other]];
      if (a == corners[around[other + 2]] && a > label)
        faces |= 1u << face;
    }
    return faces;
  }

  CellSheets sheets(std::uint16_t label) const {
    const unsigned bits = of(label);
    return cellSheets(bits, joined(label, bits));
  }
};

class SheetBuilder {
 public:
  SheetBuilder(const VoxelBox& box, const SurfaceNet& net) : m_box(box), m_net(net) {}

  LabelSheets build(std::size_t labels, std::uint64_t mostQuads) {
    countFaces(labels);
    if (m_sheets.firstQuad.back() > mostQuads)
      return {};
    makeNodes();
    makeQuads();
    makeSides();
    return std::move(m_sheets);
  }

 private:
  /// Calls visit(face, label) for both structures at each voxel edge with ends that differ.
  template <class Visit>
  void forFaces(const Visit& visit) const {
    for (std::uint32_t i = 0; i < m_net.cells.size(); ++i) {
      const SurfaceNet::Cell& cell = m_net.cells[i];
      const std::uint16_t start = m_box.label(cell.x, cell.y, cell.z);
      for (unsigned axis = 0; axis < 3; ++axis) {
        const std::uint16_t end =
            m_box.label(cell.x + (axis == 0), cell.y + (axis == 1), cell.z + (axis == 2));
        if (start == end)
          continue;
        if (start != 0)
          visit(8 * i + 2 * axis, start);
        if (end != 0)
          visit(8 * i + 2 * axis + 1, end);
      }
    }
  }

  void countFaces(std::size_t labels) {
    std::vector<std::size_t>& first = m_sheets.firstQuad;
    first.assign(labels + 2, 0);
    forFaces([&](std::uint32_t, std::uint16_t label) { ++first[label + 1u]; });
    for (std::size_t i = 1; i < first.size(); ++i)
      first[i] += first[i - 1];
  }

  /// Makes the nodes; those of a cell stand together: by label, then by sheet.
  void makeNodes() {
    const std::size_t count = m_net.cells.size();
    m_firstNode.assign(count + 1, 0);
    m_firstPoint.assign(count + 1, 0);
    parallelFor(count, quadGrain, [this](std::size_t i) {
      const SurfaceNet::Cell& cell = m_net.cells[i];
      if (cell.junction) {
        const CellLabels labels(m_box, cell);
        m_firstPoint[i + 1] = 1;
        for (std::size_t k = 0; k < labels.count; ++k)
          if (labels.labels[k] != 0)
            m_firstNode[i + 1] += labels.sheets(labels.labels[k]).count;
      } else {
        const std::uint32_t sheets = m_table[cell.corners].count;
        m_firstPoint[i + 1] = sheets;
        m_firstNode[i + 1] = cell.background ? sheets : 2 * sheets;
      }
    });
    for (std::size_t i = 0; i < count; ++i) {
      m_firstPoint[i + 1] += m_firstPoint[i];
      m_firstNode[i + 1] += m_firstNode[i];
    }
    m_sheets.cellOf.resize(m_firstPoint[count]);
    m_sheets.pointOf.resize(m_firstNode[count]);
    parallelFor(count, quadGrain, [this](std::size_t i) {
      const std::uint32_t points = m_firstPoint[i + 1] - m_firstPoint[i];
      for (std::uint32_t k = 0; k < points; ++k)
        m_sheets.cellOf[m_firstPoint[i] + k] = std::uint32_t(i);
      for (std::uint32_t node = m_firstNode[i]; node < m_firstNode[i + 1]; ++node)
        m_sheets.pointOf[node] = m_firstPoint[i] + (node - m_firstNode[i]) % points;
    });
  }

  /// Returns the label's node in the cell on the sheet that crosses the edge.
  std::uint32_t node(std::uint32_t cellIndex, std::uint16_t label, bool structureAtStart,
                     unsigned edge) const {
    const SurfaceNet::Cell& cell = m_net.cells[cellIndex];
    std::uint32_t at = m_firstNode[cellIndex];
    if (!cell.junction) {
      const CellSheets& sheets = m_table[cell.corners];
      const bool higherAtStart = (cell.corners >> edgeStart(edge) & 1u) != 0;
      if (!cell.background && structureAtStart == higherAtStart)
        at += sheets.count;
      return at + sheets.ofEdge[edge];
    }
    const CellLabels labels(m_box, cell);
    for (std::size_t k = 0; labels.labels[k] != label; ++k)
      if (labels.labels[k] != 0)
        at += labels.sheets(labels.labels[k]).count;
    return at + labels.sheets(label).ofEdge[edge];
  }

  void makeQuads() {
    std::vector<std::size_t>& first = m_sheets.firstQuad;
    m_sheets.quads.resize(first.back());
    m_labels.resize(first.back());
    // The beginning of each structure's quads advances to their end, where the next structure's
    // begin.
    forFaces([&](std::uint32_t face, std::uint16_t label) {
      m_labels[first[label]] = label;
      m_sheets.quads[first[label]++].face = face;
    });
    parallelFor(m_sheets.quads.size(), quadGrain, [this](std::size_t i) {
      LabelSheets::Quad& quad = m_sheets.quads[i];
      quad.nodes = nodesAround(quad.face, m_labels[i]);
    });
    m_labels = {};
  }

  std::array<std::uint32_t, 4> nodesAround(std::uint32_t face, std::uint16_t label) const {
    const std::uint32_t far = face / 8;
    const unsigned axis = face % 8 / 2;
    const bool atStart = face % 2 == 0;
    const std::size_t b = (axis + 1) % 3;
    const std::size_t c = (axis + 2) % 3;
    const std::uint32_t nearB = m_net.neighbours[far][2 * b];
    const std::uint32_t nearC = m_net.neighbours[far][2 * c];
    const std::uint32_t near = m_net.neighbours[nearB][2 * c];
    // The order is counter-clockwise seen from the edge's end, which is outside if the structure is
    // at its start.
    std::array<std::uint32_t, 4> nodes = {node(near, label, atStart, cellEdge(axis, 1, 1)),
                                          node(nearC, label, atStart, cellEdge(axis, 0, 1)),
                                          node(far, label, atStart, cellEdge(axis, 0, 0)),
                                          node(nearB, label, atStart, cellEdge(axis, 1, 0))};
    if (!atStart)
      std::swap(nodes[1], nodes[3]);
    return nodes;
  }

  void makeSides() {
    std::vector<std::uint32_t>& first = m_sheets.firstSide;
    first.assign(m_sheets.pointOf.size() + 2, 0);
    for (const LabelSheets::Quad& quad : m_sheets.quads)
      for (const std::uint32_t n : quad.nodes)
        ++first[n + 2];
    for (std::size_t i = 2; i < first.size(); ++i)
      first[i] += first[i - 1];
    m_sheets.sides.resize(4 * m_sheets.quads.size());
    for (const LabelSheets::Quad& quad : m_sheets.quads)
      for (std::size_t k = 0; k < 4; ++k)
        m_sheets.sides[first[quad.nodes[k] + 1]++] = {quad.nodes[(k + 1) % 4],
                                                      quad.nodes[(k + 3) % 4]};
    first.pop_back();
  }

  const VoxelBox& m_box;
  const SurfaceNet& m_net;
  CellSheetTable m_table;
  LabelSheets m_sheets;
  std::vector<std::uint32_t> m_firstNode;   ///< start of each cell's nodes, and one more
  std::vector<std::uint32_t> m_firstPoint;  ///< likewise for points
  std::vector<std::uint16_t> m_labels;      ///< label of each quad
};

}  // namespace

LabelSheets labelSheets(const VoxelBox& box, const SurfaceNet& net, std::size_t labels,
                        std::uint64_t mostQuads) {
  return SheetBuilder(box, net).build(labels, mostQuads);
}

}  // namespace sline::model
