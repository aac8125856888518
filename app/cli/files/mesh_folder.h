// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/base/result.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// Writes each structure as a binary PLY file, exact and marked as LPS, in sub-folders named like
/// its groups, so that importing the folder gives names and groups back; and writes a list of the
/// files. The folder must be new or empty, or hold such a list: then the files it names are
/// replaced, and nothing else is touched. Names become file names unchanged except for '/'.
Status writeMeshFolder(const model::Scene& scene, const std::filesystem::path& folder);

}  // namespace sline::cli
