// SPDX-License-Identifier: Apache-2.0
// How long a unit is and where up is in what assimp has read. It passes on these things differently
// from format to format.
#pragma once

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <string>

namespace sline::model {

struct AssimpConvention {
  /// What the nodes below the root are put through: from assimp's coordinates to the file's own,
  /// or, where the axes are none that RawMesh tells of, to ones with z up.
  glm::dmat4 below{1.0};
  bool yUp = false;  ///< as of RawMesh, of what comes of `below`
  float millimetresPerUnit = 1.0f;
  std::string unitReason;  ///< empty: nothing says how long a unit is
  bool light = false;      ///< colours are amounts of light, not yet sRGB
};

/// FBX: `UnitScaleFactor` centimetres; right, up and front by `CoordAxis`, `UpAxis` and
/// `FrontAxis`. assimp passes these on as metadata and applies none of them.
AssimpConvention fbxConvention(const aiScene& scene);
/// COLLADA: assimp scales to metres and turns +y up, all in the root's matrix, which is taken back.
AssimpConvention colladaConvention(const aiScene& scene);
/// Blender: +z up, as assimp leaves it; lengths mean what the person meant.
AssimpConvention blendConvention(const aiScene& scene);

/// assimp's matrices are stored by rows.
glm::dmat4 matrixOf(const aiMatrix4x4& matrix);

}  // namespace sline::model
