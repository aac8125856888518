// SPDX-License-Identifier: Apache-2.0
// Says what the coordinates of a scene stand for, as far as its files tell: molecules have no left
// and right, and are drawn larger than life.
#pragma once

#include <cstdint>
#include <string_view>

#include "model/scene/scene.h"

namespace sline::model {

/// What a millimetre of the patient's frame stands for.
enum class DrawnUnit : std::uint8_t { millimetre, angstrom };

/// What the provenance of a molecule's surfaces gives as the reason for their unit.
inline constexpr std::string_view angstromReason = "1 Å is drawn as 1 mm";

/// What the provenance says of coordinates whose directions nobody knows.
inline constexpr std::string_view fileFrame = "file";

/// Returns the unit's symbol: "mm" or "Å".
std::string_view symbolOf(DrawnUnit unit);

/// Returns the unit of lengths in the scene: ångströms where all that is visible and comes from
/// files is of molecules.
DrawnUnit drawnUnit(const Scene& scene);

/// Tells whether anything visible comes from files of known directions, or nothing is visible.
bool hasSides(const Scene& scene);

}  // namespace sline::model
