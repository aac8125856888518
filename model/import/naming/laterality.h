// SPDX-License-Identifier: Apache-2.0
// Finds out which side is left by a vote of the names on the frame of files with a silent header,
// and converts a file's frame to the patient frame LPS.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Describes a structure as the vote sees it: its name and the middle of its box, in the file's
/// coordinates (glTF: already turned upright).
struct NamedPosition {
  std::string name;
  float x = 0.0f;
};

struct FrameVote {
  int lps = 0;  ///< names that speak for +x = patient's left
  int ras = 0;
  /// Returns the frame, or nothing where no name has a side or the names disagree evenly.
  std::optional<Frame> winner() const;
  /// Returns "vote: 20 of 22 left/right names".
  std::string text() const;
};

/// Lets the names vote. Pairs "left kidney"/"right kidney" vote by comparing places; a name without
/// its counterpart votes by its side of the midline between the pairs or, without pairs, of the
/// spine. Differences below 1 % of the scene's width say nothing.
FrameVote voteOnFrame(std::span<const NamedPosition> places);

/// Returns those of the places, in order, that contradict their names if +x is the patient's left,
/// by the same comparisons; of a pair both are returned.
std::vector<std::size_t> namedForOtherSide(std::span<const NamedPosition> places);

/// Turns axes with y up (RawMesh::yUp) to axes with z up, a rotation: (x, −z, y). It turns the axes
/// of glTF (+x the patient's left, +z to the front) into LPS.
inline glm::vec3 uprightToLps(const glm::vec3& p) {
  return {p.x, -p.z, p.y};
}
/// Converts RAS ↔ LPS by half a turn about z, so that triangles keep their orientation.
inline glm::vec3 halfTurn(const glm::vec3& p) {
  return {-p.x, -p.y, p.z};
}

/// Returns "LPS", "RAS" or "file".
std::string frameName(Frame frame);

}  // namespace sline::model
