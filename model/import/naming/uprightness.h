// SPDX-License-Identifier: Apache-2.0
// Finds out by names whether z leads to the head: programs for modelling write y up, and a mesh
// file does not say so.
#pragma once

#include <span>
#include <string_view>

#include "model/import/naming/laterality.h"
#include "model/scene/evidence.h"

namespace sline::model {

/// Says so, as a remark.
inline constexpr std::string_view notUpright =
    "names say that z does not lead to the head: turn the files";

/// Returns how it is known that +z leads to the head: voted where what lies high in every body
/// ("liver", "heart", "superior …") lies above what lies low ("bladder", "femur", "inferior …") and
/// no farther away along another axis; conflict where two names each at least, whose places are far
/// apart, say otherwise; else assumed.
Evidence uprightEvidence(std::span<const NamedPosition> places);

}  // namespace sline::model
