// SPDX-License-Identifier: Apache-2.0
// Makes surfaces of volume files, as the table of file kinds wants them.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Returns the surfaces of all volumes that came from a file of `bytes` bytes: the cost of a small
/// file is bounded by its size. Errors are those of labelSurfaces.
Result<RawMeshes> volumeSurfaces(const LabelVolumes& volumes, std::uint64_t bytes,
                                 const ReadOptions& options);

/// Returns a structure for each threshold that is meant for the scan, which came from the file or
/// folder of that name, and the scan itself where scans are kept. A threshold that finds nothing
/// becomes a warning; it is an error only where nothing is left.
Result<RawMeshes> scanSurfaces(const RawScan& scan, const ReadOptions& options);

/// Reads label volumes and scans of any format.
Result<RawMeshes> readVolumeSurfaces(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
