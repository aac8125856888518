// SPDX-License-Identifier: Apache-2.0
// Declares one function per file format, which reads a file into the surfaces in it, in the file's
// own coordinates. Each returns an error naming file, place, reason and remedy where nothing can be
// read, never throws, never allocates more than a small multiple of the file's size, and parses
// numbers independently of the locale.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

Result<RawMeshes> readObj(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readStl(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readPly(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readOff(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readThreeDs(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readThreeMf(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readGifti(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readFreeSurferSurface(const std::filesystem::path& file,
                                        const ReadLimits& limits);

/// Tells by its name and first bytes whether a file that lies in a folder is a surface of that
/// kind: other programs use FreeSurfer's endings too, GIFTI holds numbers of surfaces as well, and
/// blown up or spherical surfaces are no anatomy, though they are read where they are named.
bool isGiftiAnatomy(const std::filesystem::path& file);
bool isFreeSurferAnatomy(const std::filesystem::path& file);

}  // namespace sline::model
