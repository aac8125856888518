// SPDX-License-Identifier: Apache-2.0
// Encodes a mesh exactly, as bytes that a general compressor makes small. Neighbours in the list
// are near each other in space, so the differences of their numbers are small, and bytes of the
// same weight stand together: the highest are nearly all zero. Differences of floats taken as whole
// numbers in the order of their values: Lindstrom and Isenburg, Fast and efficient compression of
// floating-point data, IEEE TVCG 12(5), 2006; bytes put in planes: the shuffle filter of HDF5;
// vertices counted back from the highest used so far: Chun, WebGL models: end-to-end, in OpenGL
// Insights, 2012.
#pragma once

#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/geometry/mesh.h"

namespace sline::model {

/// Returns 16 + 12 · vertices + 12 · triangles bytes; resources/help/scene_file.md describes them.
std::string encodedMesh(const Mesh& mesh);

/// Returns the mesh again with every bit and the order of vertices and triangles. The bytes are not
/// trusted: the error says what is wrong with them.
Result<Mesh> decodedMesh(std::string_view bytes);

}  // namespace sline::model
