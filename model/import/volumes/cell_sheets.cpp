// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/cell_sheets.h"

namespace sline::model {

namespace {

bool holds(unsigned corners, unsigned corner) {
  return (corners >> corner & 1u) != 0;
}

bool isCrossed(unsigned corners, unsigned edge) {
  const unsigned start = edgeStart(edge);
  return holds(corners, start) != holds(corners, start | 1u << edge / 4);
}

/// Returns the edge between two corners that differ in one bit.
unsigned edgeBetween(unsigned p, unsigned q) {
  const unsigned bit = p ^ q;
  const unsigned axis = bit == 1 ? 0 : bit == 2 ? 1 : 2;
  return cellEdge(axis, p >> (axis + 1) % 3 & 1u, p >> (axis + 2) % 3 & 1u);
}

/// Holds the edges before and after an edge in its cycle; each lies in another of that edge's two
/// faces.
using Links = std::array<std::uint8_t, 2>;

void linkInFace(unsigned corners, unsigned face, bool joined, std::array<Links, 12>& links) {
  const auto link = [&](unsigned e, unsigned f) {
    links[e][links[e][0] == CellSheets::none ? 0 : 1] = std::uint8_t(f);
    links[f][links[f][0] == CellSheets::none ? 0 : 1] = std::uint8_t(e);
  };
  const std::array<unsigned, 4> around = faceCorners(face);
  if (isDiagonal(corners, face)) {
    for (unsigned i = 0; i < 4; ++i)
      if (holds(corners, around[i]) != joined)
        link(edgeBetween(around[i], around[(i + 1) % 4]),
             edgeBetween(around[i], around[(i + 3) % 4]));
    return;
  }
  std::array<unsigned, 4> crossed{};
  std::size_t count = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (const unsigned e = edgeBetween(around[i], around[(i + 1) % 4]); isCrossed(corners, e))
      crossed[count++] = e;
  if (count == 2)
    link(crossed[0], crossed[1]);
}

}  // namespace

std::array<unsigned, 4> faceCorners(unsigned face) {
  const unsigned axis = face / 2;
  const unsigned base = (face & 1u) << axis;
  const unsigned b = 1u << (axis + 1) % 3;
  const unsigned c = 1u << (axis + 2) % 3;
  return {base, base | b, base | b | c, base | c};
}

bool isDiagonal(unsigned corners, unsigned face) {
  const std::array<unsigned, 4> around = faceCorners(face);
  return holds(corners, around[0]) == holds(corners, around[2]) &&
         holds(corners, around[1]) == holds(corners, around[3]) &&
         holds(corners, around[0]) != holds(corners, around[1]);
}

CellSheets cellSheets(unsigned corners, unsigned joinedFaces) {
  std::array<Links, 12> links;
  links.fill({CellSheets::none, CellSheets::none});
  for (unsigned face = 0; face < 6; ++face)
    linkInFace(corners, face, holds(joinedFaces, face), links);
  CellSheets sheets;
  sheets.ofEdge.fill(CellSheets::none);
  for (unsigned first = 0; first < 12; ++first) {
    if (links[first][0] == CellSheets::none || sheets.ofEdge[first] != CellSheets::none)
      continue;
    unsigned before = CellSheets::none;
    unsigned at = first;
    do {
      sheets.ofEdge[at] = sheets.count;
      const unsigned next = links[at][0] == before ? links[at][1] : links[at][0];
      before = at;
      at = next;
    } while (at != first);
    ++sheets.count;
  }
  return sheets;
}

CellSheetTable::CellSheetTable() {
  for (unsigned corners = 0; corners < 256; ++corners)
    m_sheets[corners] = cellSheets(corners, 0);
}

}  // namespace sline::model
