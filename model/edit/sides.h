// SPDX-License-Identifier: Apache-2.0
// Settles which sides of the body are which, where import could only assume it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

/// Says what a person finds of the sides: they are right; they are a mirror image, left and right
/// swapped alone, or front and back where only these are in doubt; or all is turned about the
/// body's axis, front and back being swapped, too, as where RAS was taken for LPS.
enum class SideAnswer { right, mirror, turn };
inline constexpr std::array<std::string_view, 3> sideAnswerNames{"right", "mirror", "turn"};

/// Tells whether anything in the scene, visible or not, has sides that are in doubt.
bool hasDoubtedSides(const Scene& scene);

/// Tells whether any structure, visible or not, has a name that is in doubt (known_frame.h).
bool hasDoubtedNames(const Scene& scene);

/// Tells whether the front is in doubt and the sides are not: a mirror image then has front and
/// back swapped.
bool isOnlyFrontDoubted(const Scene& scene);
/// Tells whether nothing is in doubt but which way leads to the head.
bool isOnlyUpDoubted(const Scene& scene);

/// Settles the sides of all that is in doubt, or of everything that has sides where nothing is.
/// That all is right settles the names that are in doubt where no sides are. What is mirrored or
/// turned keeps its outside out. Where nothing else is sure of its sides, free places of
/// annotations, sections, views and scans go with it; else they stay with what is sure, but for
/// sections of what is moved alone.
Edited withSidesSettled(const Scene& scene, SideAnswer answer);

/// Says how structures whose frame was only assumed are read, now that others have come to them.
struct FrameAnew {
  std::string frame;   ///< a name of `frames` (laterality.h), as in Provenance
  std::string reason;  ///< what decided it
  SideEvidence evidence;
  bool operator==(const FrameAnew&) const = default;
};

/// Returns the structures that were read in one frame because nothing clear told another; none
/// where they were read in different ones. What a person has settled is not among them, nor what
/// names contradict, nor what a scene around its file has placed.
std::vector<const Node*> withAssumedFrame(const Scene& scene);

/// Returns what leads from coordinates that were read in one frame to those read in the other;
/// nothing where no answer does.
std::optional<SideAnswer> answerBetween(std::string_view frame, std::string_view other);

/// Reads the structures with an assumed frame in this one: turned or mirrored as by
/// withSidesSettled, but told as what decided it says. Others stay.
Edited withFrameAnew(const Scene& scene, const FrameAnew& anew);

}  // namespace sline::model
