// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/import/foreign/assimp_convention.h"
#include "model/import/source/source.h"

namespace sline::model {

/// Returns a surface for every instance of a mesh in the scene, named like its node, in the groups
/// of the named nodes above it. Faces are cut into triangles, corners at one place are one vertex;
/// lines, points, skins, textures and animations are left out. It is an error where nothing is left
/// or the scene repeats its meshes far beyond the file's size.
Result<RawMeshes> meshesOf(const aiScene& scene, const AssimpConvention& convention,
                           const Source& source);

}  // namespace sline::model
