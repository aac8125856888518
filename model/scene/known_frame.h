// SPDX-License-Identifier: Apache-2.0
// Says what the coordinates of a scene stand for, as far as its files tell: molecules have no left
// and right, and are drawn larger than life.
#pragma once

#include <cstdint>
#include <string_view>

#include "model/scene/scene.h"

namespace sline::model {

/// What a millimetre of the patient's frame stands for; a doubted one perhaps for another length.
enum class DrawnUnit : std::uint8_t { millimetre, angstrom, doubtedMillimetre };

/// What the provenance of a molecule's surfaces gives as the reason for their unit.
inline constexpr std::string_view angstromReason = "1 Å is drawn as 1 mm";

/// What the provenance gives as the reason for what somebody has chosen.
inline constexpr std::string_view chosenReason = "chosen by the user";

/// What the provenance says of coordinates whose directions nobody knows.
inline constexpr std::string_view fileFrame = "file";

/// Tells whether nobody knows how long the unit of the structure's file is.
bool isUnitDoubted(const Provenance& from);

/// Returns the unit's symbol: "mm", "Å" or, where it is doubted, "mm?".
std::string_view symbolOf(DrawnUnit unit);

/// Returns the unit of lengths in the scene: ångströms where all that is visible and comes from
/// files is of molecules, doubted where that of anything visible is or molecules lie beside others.
DrawnUnit drawnUnit(const Scene& scene);

/// Tells whether anything visible comes from files of known directions, or nothing is visible.
bool hasSides(const Scene& scene);

/// Holds what may be said of the body's sides where a scene is drawn.
struct KnownSides {
  bool any = true;        ///< there are sides at all: hasSides
  SideEvidence evidence;  ///< the least sure of all that is drawn
  /// Tells whether the directions along the axis of LPS are to carry a question mark.
  bool inDoubt(int axis) const;
  /// Tells whether any direction is.
  bool inDoubt() const { return any && !evidence.isSure(); }
  bool operator==(const KnownSides&) const = default;
};

/// Stands behind words that are in doubt.
inline constexpr std::string_view doubtMark = " (?)";

/// Tells whether the structure was found to lie on the other side than its name says, and nobody
/// has said since that this is right.
bool isNameDoubted(const Node& node);
/// Returns the node's name, marked where it is in doubt.
std::string markedName(const Node& node);
/// Tells whether the annotation says what such a structure is: as a label, a pin or a callout on
/// it.
bool namesInDoubt(const Scene& scene, const Annotation& annotation);

/// Returns how sure the sides are of what is visible, and of the scans.
KnownSides knownSides(const Scene& scene);

/// Returns how sure the sides are of a structure, going by the reason that files of older programs
/// give for its frame.
SideEvidence evidenceOfReason(std::string_view frameReason);

/// What the provenance gives as the reason for a frame where nothing tells it, and how that
/// begins where names have voted: "vote: 20 of 22 left/right names".
inline constexpr std::string_view nothingTellsFrame =
    "no header and no left/right names: LPS assumed";
inline constexpr std::string_view votedFrame = "vote: ";
/// And where a person has settled it afterwards.
inline constexpr std::string_view confirmedFrame = "confirmed by hand";
inline constexpr std::string_view mirroredFrame = "mirrored by hand";
inline constexpr std::string_view turnedFrame = "turned by hand";

/// Tells whether so few votes are against that they do not matter: at most one in four.
constexpr bool isClearVote(int against, int all) {
  return 4 * against <= all;
}

}  // namespace sline::model
