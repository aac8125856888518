// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

Result<RawMeshes> readGltf(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
