// SPDX-License-Identifier: Apache-2.0
// Writes and reads the atoms that a structure keeps, one text for each residue: its name and, after
// a bar, x, y, z and radius of each atom in millimetres.
#pragma once

#include <nlohmann/json.hpp>

#include "model/geometry/atom_set.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

nlohmann::ordered_json atomsJson(const AtomSet& atoms);
KeptAtoms atomsFrom(const JsonValue& value);

}  // namespace sline::model
