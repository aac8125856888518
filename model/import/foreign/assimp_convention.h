// SPDX-License-Identifier: Apache-2.0
// Determines the length of a unit and the upward axis in the data that assimp has read. assimp
// passes on these things differently from format to format.
#pragma once

#include <assimp/scene.h>

#include <glm/mat4x4.hpp>
#include <string>

namespace sline::model {

struct AssimpConvention {
  /// Takes the nodes below the root from assimp's coordinates to the file's own, or, where RawMesh
  /// has no way to describe those axes, to axes with z up.
  glm::dmat4 below{1.0};
  bool yUp = false;  ///< as RawMesh::yUp, of the coordinates after `below`
  float millimetresPerUnit = 1.0f;
  std::string unitReason;  ///< empty: nothing says how long a unit is
  bool light = false;      ///< colours are linear amounts of light, not yet sRGB
};

/// Returns the convention of FBX: `UnitScaleFactor` centimetres; right, up and front by
/// `CoordAxis`, `UpAxis` and `FrontAxis`. assimp passes these on as metadata and applies none of
/// them.
AssimpConvention fbxConvention(const aiScene& scene);
/// Returns the convention of COLLADA: assimp scales to metres and turns +y up, all in the root's
/// matrix, which is undone here.
AssimpConvention colladaConvention(const aiScene& scene);
/// Returns the convention of Blender: +z up, as assimp leaves it; only the author knows what a
/// length means.
AssimpConvention blendConvention(const aiScene& scene);

/// Converts assimp's matrix, which is stored by rows.
glm::dmat4 matrixOf(const aiMatrix4x4& matrix);

}  // namespace sline::model
