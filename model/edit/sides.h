// SPDX-License-Identifier: Apache-2.0
// Settles which sides of the body are which, where import could only assume it.
#pragma once

#include <array>
#include <string_view>

#include "model/edit/edited.h"

namespace sline::model {

/// Says what a person finds of the sides: they are right; they are a mirror image, left and right
/// swapped alone, or front and back where only these are in doubt; or all is turned about the
/// body's axis, front and back being swapped, too, as where RAS was taken for LPS.
enum class SideAnswer { right, mirror, turn };
inline constexpr std::array<std::string_view, 3> sideAnswerNames{"right", "mirror", "turn"};

/// Tells whether anything in the scene, visible or not, has sides that are in doubt.
bool hasDoubtedSides(const Scene& scene);

/// Tells whether what is in doubt is the front alone: a mirror image then has front and back
/// swapped.
bool isOnlyFrontDoubted(const Scene& scene);

/// Settles the sides of all that is in doubt, or of everything that has sides where nothing is.
/// What is mirrored or turned keeps its outside out. Where nothing else is sure of its sides, free
/// places of annotations, sections, views and scans go with it; else they stay with what is sure,
/// but for sections of what is moved alone.
Edited withSidesSettled(const Scene& scene, SideAnswer answer);

}  // namespace sline::model
