// SPDX-License-Identifier: Apache-2.0
// Finds out by names whether z leads to the head: programs for modelling write y up, and a mesh
// file does not say so.
#pragma once

#include <span>
#include <string_view>

#include "model/import/naming/laterality.h"

namespace sline::model {

/// Says so, as a remark.
inline constexpr std::string_view notUpright =
    "names say that z does not lead to the head: turn the files";

/// Tells whether the places contradict that +z leads to the head: of what lies high in every body
/// ("liver", "heart") and what lies low ("bladder", "femur"), two names each at least, the middles
/// lie the other way round, or farther apart along another axis.
bool contradictsUpright(std::span<const NamedPosition> places);

}  // namespace sline::model
