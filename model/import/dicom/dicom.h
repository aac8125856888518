// SPDX-License-Identifier: Apache-2.0
// The door to DICOM: which objects hold segmentations, and who makes surfaces of them.
#pragma once

#include <filesystem>

#include "model/import/raw_mesh.h"
#include "model/import/read_options.h"

namespace sline::model {

/// RT structure sets and segmentations; other kinds of object are an error that names their kind.
/// The scene gets shapes, names, colours and groups of structures and nothing else of the file.
Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
