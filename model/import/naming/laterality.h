// SPDX-License-Identifier: Apache-2.0
// Finds out which side is left by a vote of the names on the frame of files with a silent header,
// and converts a file's frame to the patient frame LPS.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Describes a structure as the vote sees it: its name and the middle of its box, in the file's
/// coordinates (glTF: already turned upright).
struct NamedPosition {
  std::string name;
  float x = 0.0f;
  float y = 0.0f;
  float halfWidth = 0.0f;  ///< half of the box's size along x
  float z = 0.0f;
};

struct FrameVote {
  int lps = 0;  ///< names that speak for +x = patient's left
  int ras = 0;
  int pairsLps = 0;  ///< those of them that are two of one name, left and right
  int pairsRas = 0;
  bool compared = false;  ///< a left one was compared with a right one
  bool byOrigin = false;  ///< there was nothing to compare with but a hull or the origin
  /// Returns the frame, or nothing where no name has a side or the names disagree evenly.
  std::optional<Frame> winner() const;
  /// Tells whether that can be taken for certain: not where one name alone speaks or only the
  /// origin tells the sides apart, nor where more than one vote in four is against.
  bool isClear() const;
  /// Tells whether that is enough to contradict a frame that a file states, in which +x is the left
  /// or is not: a clear vote, and most of the pairs.
  bool refutes(bool left) const;
  /// Returns "vote: 20 of 22 left/right names", or "weak vote: …" where it is not clear.
  std::string text() const;
};

/// Lets the names vote. Pairs "left kidney"/"right kidney" vote by comparing places; a name without
/// its counterpart, and an organ that lies on one side by nature ("liver"), votes by its side of
/// the midline between the pairs or, without pairs, of the spine and its like. Without these, each
/// votes by its side of the line that parts names of the left from names of the right, or at last
/// of the body's hull or the coordinates' origin. Places that are hardly beside the line, and
/// differences below 1 % of the scene's width, say nothing.
FrameVote voteOnFrame(std::span<const NamedPosition> places);

/// Returns those of the places, in order, that contradict their names if +x is the patient's left,
/// by the same comparisons but for hull and origin, and lie wholly on the other side; of a pair
/// both are returned.
std::vector<std::size_t> namedForOtherSide(std::span<const NamedPosition> places);

struct FrontVote {
  int posterior = 0;  ///< comparisons that speak for +y = the back
  int anterior = 0;
  /// Tells whether +y is the back; nothing where no pair tells or pairs disagree evenly.
  std::optional<bool> toTheBack() const;
};
/// Compares the places of names that are alike but for "anterior" and "posterior" (or "ventral" and
/// "dorsal"), and, within trunk, head and knee, what lies in front in every body with what lies
/// behind ("bladder" with "rectum"). Differences below 1 % of the scene's depth say nothing.
FrontVote voteOnFront(std::span<const NamedPosition> places);

/// Turns axes with y up (RawMesh::yUp) to axes with z up, a rotation: (x, −z, y). It turns the axes
/// of glTF (+x the patient's left, +z to the front) into LPS.
inline glm::vec3 uprightToLps(const glm::vec3& p) {
  return {p.x, -p.z, p.y};
}
/// Converts RAS ↔ LPS by half a turn about z, so that triangles keep their orientation.
inline glm::vec3 halfTurn(const glm::vec3& p) {
  return {-p.x, -p.y, p.z};
}

/// Describes a frame: its name and where its axes point to; z points to the head.
struct FrameAxes {
  Frame frame;
  std::string_view name;
  bool left;       ///< +x is the patient's left
  bool posterior;  ///< +y is the patient's back
  /// Tells whether coordinates are the mirror image of LPS.
  constexpr bool mirrored() const { return left != posterior; }
};
/// Lists all frames. Coordinates left as in the file count as LPS.
inline constexpr std::array<FrameAxes, 5> frames{{{Frame::lps, "LPS", true, true},
                                                  {Frame::ras, "RAS", false, false},
                                                  {Frame::las, "LAS", true, false},
                                                  {Frame::rps, "RPS", false, true},
                                                  {Frame::file, "file", true, true}}};
/// Returns the axes of a frame; by name, where none has it those of LPS.
const FrameAxes& axesOf(Frame frame);
const FrameAxes& axesOf(std::string_view name);
/// Returns the axes in which a file's coordinates are read. Where it leaves only the side open
/// (RawMesh::onlySideOpen), y runs to the front whatever the frame says.
FrameAxes axesIn(Frame frame, bool onlySideOpen);
/// Returns the frame with these axes.
Frame frameWith(bool left, bool posterior);

/// Returns the frame's name in `frames`.
std::string frameName(Frame frame);

}  // namespace sline::model
