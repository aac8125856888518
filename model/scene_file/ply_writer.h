// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns the mesh as binary little-endian PLY, with every float bit for bit. `comment` is one
/// line of text.
std::string plyText(const Mesh& mesh, const std::string& comment);

}  // namespace sline::model
