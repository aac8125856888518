// SPDX-License-Identifier: Apache-2.0
// Declares the functions that the reader of glTF is given to unpack compressed data. The libraries
// that do so are not this library's: without them it leaves compressed meshes out and says so.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Describes a buffer view under EXT_meshopt_compression.
struct GltfPackedView {
  std::string_view bytes;
  std::size_t count = 0;
  std::size_t stride = 0;  ///< bytes of one of `count` elements, at most 256
  std::string mode;        ///< as the extension has it: ATTRIBUTES, TRIANGLES or INDICES
  std::string filter;      ///< empty or NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL
};

/// Describes a primitive under KHR_draco_mesh_compression.
struct GltfPackedMesh {
  std::string_view bytes;
  std::uint32_t positions = 0;  ///< the unique id of the attribute that has them
  ReadLimits limits;
};

struct GltfUnpackedMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> corners;  ///< three to a triangle, each below positions.size()
};

/// Holds the decoders. Their errors give only the reason.
struct GltfDecoders {
  Result<std::string> (*view)(const GltfPackedView&) = nullptr;  ///< returns count · stride bytes
  Result<GltfUnpackedMesh> (*mesh)(const GltfPackedMesh&) = nullptr;
};

/// Tells whether the file mentions one of the two extensions; false for one that cannot be read.
bool isCompressedGltf(const std::filesystem::path& file);

/// Reads like readGltf (readers.h), but unpacks what the decoders can.
Result<RawMeshes> readGltfWith(const GltfDecoders& decoders, const std::filesystem::path& file,
                               const ReadLimits& limits);

}  // namespace sline::model
