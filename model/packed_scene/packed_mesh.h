// SPDX-License-Identifier: Apache-2.0
// Encodes a mesh in few bytes, for pages that travel. Triangles are listed so that most share an
// edge with one of the last; each is then a byte that says which edge and which vertex (after
// Kapoulkine's index codec of meshoptimizer, 2017, and the cut-border machine of Gumhold and
// Straßer, SIGGRAPH 1998). Positions are whole numbers of 16 bits, of which only the difference
// from a parallelogram's fourth corner is kept (Touma and Gotsman, Triangle mesh compression,
// Graphics Interface 1998), in planes of bytes. A general compressor makes the rest small.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/geometry/mesh.h"

namespace sline::model {

/// A mesh as bytes, and what became of its triangles and vertices.
struct PackedMesh {
  /// Says where a triangle is in the decoded mesh, and which of its corners became the first.
  struct Place {
    std::uint32_t triangle = 0;
    std::uint8_t first = 0;
  };
  std::string bytes;
  std::vector<Place> places;            ///< one for each triangle of the mesh
  std::vector<std::uint32_t> vertices;  ///< for each decoded vertex the one of the mesh
};

/// Encodes the mesh. Vertices that no triangle uses are left out; the others move by at most
/// 1/131,070 of the mesh's largest side.
PackedMesh packedMesh(const Mesh& mesh);

/// Returns the mesh of the bytes, which are not trusted: the error says what is wrong with them.
Result<Mesh> unpackedMesh(std::string_view bytes);

}  // namespace sline::model
