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

/// What the reason for a unit ends with where it makes what is named larger or smaller than such
/// structures are, and nobody has said that it is right.
inline constexpr std::string_view unlikelySizes = "; sizes are not those of what is named";

/// What the provenance gives as the reason for what somebody has chosen.
inline constexpr std::string_view chosenReason = "chosen by the user";

/// What the provenance says of coordinates whose directions nobody knows.
inline constexpr std::string_view fileFrame = "file";

/// Tells whether nobody knows how long the unit of the structure's file is.
bool isUnitDoubted(const Provenance& from);

/// Returns the unit's symbol: "mm", "Å" or, where it is doubted, "mm?".
std::string_view symbolOf(DrawnUnit unit);

/// Returns the unit of lengths in the scene: ångströms where all that is visible and comes from
/// files is of molecules, doubted where that of anything visible is.
DrawnUnit drawnUnit(const Scene& scene);

/// Tells whether anything visible comes from files of known directions, or nothing is visible.
bool hasSides(const Scene& scene);

}  // namespace sline::model
