// SPDX-License-Identifier: Apache-2.0
// Readers that stand on libraries which a spoiled file may crash, keep busy for ever or make take
// all memory. Whoever calls them does so in a process of its own, whose time and memory are
// limited. What they promise besides is what readers/readers.h says.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// FBX from 7.1 on, text or binary (through assimp). Unit and axes as its global settings say; it
/// stands as it was bound, at rest.
Result<RawMeshes> readFbx(const std::filesystem::path& file, const ReadOptions& options);
/// COLLADA (through assimp), in the unit and with the axis up that its asset says.
Result<RawMeshes> readCollada(const std::filesystem::path& file, const ReadOptions& options);
/// A scene of Blender, not packed by zstd (through assimp). +z is up; the unit is open.
Result<RawMeshes> readBlend(const std::filesystem::path& file, const ReadOptions& options);

/// The outer surface of the cells of a VTK unstructured grid in XML (through VTK).
Result<RawMeshes> readVtu(const std::filesystem::path& file, const ReadOptions& options);

/// glTF or GLB with parts that are compressed (readers/gltf_decoders.h) by Draco or meshoptimizer.
Result<RawMeshes> readCompressedGltf(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
