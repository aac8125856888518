// SPDX-License-Identifier: Apache-2.0
// Repairs faults of real files that drawing cannot bear: duplicate faces or faces without area,
// duplicate vertices at a seam, neighbours turned against each other, surfaces inside out.
#pragma once

#include <string>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::model {

struct RepairReport {
  int degenerateFaces = 0;  ///< removed; faces without area that hold a surface together stay
  int duplicateFaces = 0;   ///< removed
  int turnedFaces = 0;
  int mergedVertices = 0;      ///< exact duplicates, merged because that closed edges
  bool notOrientable = false;  ///< a piece (a Möbius strip) has no consistent orientation

  int faces() const { return degenerateFaces + duplicateFaces + turnedFaces; }
};

/// Repairs in place: removes repeated and degenerate faces, merges equal vertices where that closes
/// the surface, makes each connected piece consistent (the majority decides), turns closed pieces
/// outward by their signed volume and cavities (closed pieces inside an odd number of others)
/// inward. A mesh without these faults keeps every bit. Indices must be in range, coordinates
/// finite.
RepairReport repair(std::vector<glm::vec3>& positions, std::vector<Triangle>& triangles);

}  // namespace sline::model
