// SPDX-License-Identifier: Apache-2.0
// Reads entries of the Protein Data Bank as surfaces: one for each chain, balls and sticks for the
// molecules bound to them. One ångström is one unit; x, y and z stay as they are in the file, which
// preserves handedness.
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Reads a PDB file. Errors name file, line, reason and remedy. Waters, models after the first and
/// alternative locations are left out with a warning. The atoms are those of the file or of the
/// assembly that the options ask for; without one, Backbone::note tells which assemblies there are.
Result<RawMeshes> readPdb(const std::filesystem::path& file, const ReadOptions& options);
Result<RawMeshes> readMmcif(const std::filesystem::path& file, const ReadOptions& options);
Result<RawMeshes> readMmjson(const std::filesystem::path& file, const ReadOptions& options);

/// Tells whether the file, packed or not, begins as mmJSON does; other kinds of files are called
/// .json too.
bool isMmjson(const std::filesystem::path& file);

}  // namespace sline::model
