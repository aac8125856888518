// SPDX-License-Identifier: Apache-2.0
// Entries of the Protein Data Bank as surfaces: one for each chain, balls and sticks for what is
// bound to them. One ångström is one unit; x, y and z stay as they are in the file, so that
// handedness does.
#pragma once

#include <filesystem>

#include "model/import/raw_mesh.h"

namespace sline::model {

/// Errors name file, line, reason and remedy. Waters, models after the first and alternative
/// locations are left out with a warning.
Result<RawMeshes> readPdb(const std::filesystem::path& file, const ReadOptions& options);
Result<RawMeshes> readMmcif(const std::filesystem::path& file, const ReadOptions& options);

}  // namespace sline::model
