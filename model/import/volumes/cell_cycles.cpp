// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/cell_cycles.h"

#include <algorithm>

namespace sline::model {

namespace {

bool holds(unsigned corners, unsigned corner) {
  return (corners >> corner & 1u) != 0;
}

bool isCrossed(unsigned corners, unsigned edge) {
  const unsigned start = CellCycles::edgeStart(edge);
  return holds(corners, start) != holds(corners, start | 1u << edge / 4);
}

/// The edge between two corners that differ in one bit.
unsigned edgeBetween(unsigned p, unsigned q) {
  const unsigned bit = p ^ q;
  const unsigned axis = bit == 1 ? 0 : bit == 2 ? 1 : 2;
  return CellCycles::edge(axis, p >> (axis + 1) % 3 & 1u, p >> (axis + 2) % 3 & 1u);
}

/// The next edge of a cycle and the face through which it is reached, for both ways.
struct Links {
  std::array<std::uint8_t, 2> edge{CellCycles::none, CellCycles::none};
  std::array<std::uint8_t, 2> face{};

  void add(unsigned toEdge, unsigned throughFace) {
    const std::size_t free = edge[0] == CellCycles::none ? 0 : 1;
    edge[free] = std::uint8_t(toEdge);
    face[free] = std::uint8_t(throughFace);
  }
};

void linkInFace(unsigned corners, unsigned face, std::array<Links, 12>& links) {
  const auto link = [&](unsigned e, unsigned f) {
    links[e].add(f, face);
    links[f].add(e, face);
  };
  const std::array<unsigned, 4> around = CellCycles::faceCorners(face);
  if (CellCycles::isDiagonal(corners, face)) {
    for (unsigned i = 0; i < 4; ++i)
      if (holds(corners, around[i]))
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

/// Twice the signed volume that the ring of face centres spans with the centre, along the way out
/// of the structure: positive for a ring that turns counter-clockwise as seen from outside.
int turn(unsigned corners, const CellCycles::Ring& ring) {
  std::array<int, 3> outward{};
  for (unsigned corner = 0; corner < 8; ++corner)
    for (unsigned axis = 0; axis < 3; ++axis)
      outward[axis] += (holds(corners, corner) ? -1 : 1) * (holds(corner, axis) ? 1 : -1);
  std::array<int, 3> area{};
  for (unsigned i = 0; i < ring.count; ++i) {
    std::array<int, 3> p{};
    std::array<int, 3> q{};
    p[ring.faces[i] / 2] = ring.faces[i] % 2 ? 1 : -1;
    const unsigned next = ring.faces[(i + 1) % ring.count];
    q[next / 2] = next % 2 ? 1 : -1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      area[axis] += p[(axis + 1) % 3] * q[(axis + 2) % 3] - p[(axis + 2) % 3] * q[(axis + 1) % 3];
  }
  return area[0] * outward[0] + area[1] * outward[1] + area[2] * outward[2];
}

}  // namespace

std::array<unsigned, 4> CellCycles::faceCorners(unsigned face) {
  const unsigned axis = face / 2;
  const unsigned base = (face & 1u) << axis;
  const unsigned b = 1u << (axis + 1) % 3;
  const unsigned c = 1u << (axis + 2) % 3;
  return {base, base | b, base | b | c, base | c};
}

bool CellCycles::isDiagonal(unsigned corners, unsigned face) {
  const std::array<unsigned, 4> around = faceCorners(face);
  return holds(corners, around[0]) == holds(corners, around[2]) &&
         holds(corners, around[1]) == holds(corners, around[3]) &&
         holds(corners, around[0]) != holds(corners, around[1]);
}

unsigned CellCycles::edgeInFace(unsigned face, unsigned corner) {
  return edgeBetween(corner, corner ^ 1u << (face / 2 + 1) % 3);
}

CellCycles::CellCycles() {
  for (unsigned corners = 0; corners < 256; ++corners) {
    std::array<Links, 12> links;
    for (unsigned face = 0; face < 6; ++face)
      linkInFace(corners, face, links);
    std::array<std::uint8_t, 12>& cycles = m_cycleOf[corners];
    cycles.fill(none);
    std::uint8_t count = 0;
    Ring ring;
    for (unsigned first = 0; first < 12; ++first) {
      if (links[first].edge[0] == none || cycles[first] != none)
        continue;
      ring.count = 0;
      unsigned at = first;
      std::size_t way = 0;
      do {
        cycles[at] = count;
        const unsigned next = links[at].edge[way];
        const std::uint8_t through = links[at].face[way];
        ring.faces[ring.count++] = through;
        // Two edges may be linked through one face only.
        way = links[next].face[0] == through ? 1 : 0;
        at = next;
      } while (at != first);
      ++count;
    }
    if (count != 1)
      continue;
    if (turn(corners, ring) < 0)
      std::reverse(ring.faces.begin(), ring.faces.begin() + ring.count);
    m_rings[corners] = ring;
  }
}

}  // namespace sline::model
