// SPDX-License-Identifier: Apache-2.0
// Declares readers that stand on libraries which a damaged file may crash, keep busy for ever or
// make take all memory. They must be called in a process of its own, with limited time and memory.
// They also keep the promises of readers/readers.h.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Reads FBX from 7.1 on, text or binary (through assimp), with unit and axes as its global
/// settings say and in its bind pose.
Result<RawMeshes> readFbx(const std::filesystem::path& file, const ReadOptions& options);
/// Reads COLLADA (through assimp), in the unit and with the upward axis that its asset states.
Result<RawMeshes> readCollada(const std::filesystem::path& file, const ReadOptions& options);
/// Reads a Blender scene that is not packed by zstd (through assimp). +z is up; the unit is open.
Result<RawMeshes> readBlend(const std::filesystem::path& file, const ReadOptions& options);

/// Reads the outer surface of the cells of a VTK unstructured grid in XML (through VTK).
Result<RawMeshes> readVtu(const std::filesystem::path& file, const ReadOptions& options);

/// Reads glTF or GLB with parts that are compressed (readers/gltf_decoders.h) by Draco or
/// meshoptimizer.
Result<RawMeshes> readCompressedGltf(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
