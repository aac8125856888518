// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

Result<RawMeshes> readLegacyVtk(const std::filesystem::path& file, const ReadLimits& limits);
Result<RawMeshes> readVtp(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
