// SPDX-License-Identifier: Apache-2.0
// Volume files → surfaces, as the table of file kinds wants them.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// The surfaces of all volumes that came from a file of `bytes` bytes: what a small file may cost
/// is bounded by its size. Errors as those of labelSurfaces.
Result<RawMeshes> volumeSurfaces(const LabelVolumes& volumes, std::uint64_t bytes,
                                 const ReadOptions& options);

/// A structure for each threshold that is meant for the scan, which came from the file or folder of
/// that name, and the scan itself where scans are kept. What a threshold finds nothing for becomes
/// a warning; an error only where nothing came of any.
Result<RawMeshes> scanSurfaces(const RawScan& scan, const ReadOptions& options);

/// Label volumes and scans of any format.
Result<RawMeshes> readVolumeSurfaces(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
