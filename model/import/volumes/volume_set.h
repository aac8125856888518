// SPDX-License-Identifier: Apache-2.0
// Reads several label volumes of one folder, as programs write them that give each structure a
// file.
#pragma once

#include <filesystem>
#include <span>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Reads the files together: structures on one grid that do not overlap become one volume, so that
/// those that touch share their faces; the others are kept apart. A structure that its file does
/// not name is called after the file, and RawMesh::file says from which each came. Files that
/// cannot be read are left out with a warning each, as are scans unless the options have something
/// to do with them, empty masks with one warning for all. It is an error only where nothing is
/// left; it is then the first file's.
Result<RawMeshes> readVolumeSet(std::span<const std::filesystem::path> files,
                                const ReadOptions& options);

}  // namespace sline::model
