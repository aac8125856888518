// SPDX-License-Identifier: Apache-2.0
// Which side is left: the vote of the names on the frame of files whose header is silent, and the
// way from a file's frame to the patient frame LPS.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// A structure as the vote sees it: its name and the middle of its box, in the file's coordinates
/// (glTF: already turned upright).
struct NamedPlace {
  std::string name;
  float x = 0.0f;
};

struct FrameVote {
  int lps = 0;  ///< names that speak for +x = patient's left
  int ras = 0;
  /// Nothing where no name has a side or the names disagree evenly.
  std::optional<Frame> winner() const;
  /// "vote: 20 of 22 left/right names"
  std::string text() const;
};

/// Pairs "left kidney"/"right kidney" vote by comparing places; a name without its counterpart
/// votes by its side of the midline between the pairs or, without pairs, of the spine. Differences
/// below 1 % of the scene's width say nothing.
FrameVote voteOnFrame(std::span<const NamedPlace> places);

/// Those of the places, in order, whose names say the other side than where they are if +x is the
/// patient's left, by the same comparisons; both of a pair.
std::vector<std::size_t> onTheOtherSide(std::span<const NamedPlace> places);

/// From axes with y up (RawMesh::yUp) to those with z up, a rotation: (x, −z, y). Of glTF (+x the
/// patient's left, +z to the front) it makes LPS.
inline glm::vec3 uprightToLps(const glm::vec3& p) {
  return {p.x, -p.z, p.y};
}
/// RAS ↔ LPS: half a turn about z, so that triangles keep their orientation.
inline glm::vec3 halfTurn(const glm::vec3& p) {
  return {-p.x, -p.y, p.z};
}

/// "LPS", "RAS" or "file".
std::string frameName(Frame frame);

}  // namespace sline::model
