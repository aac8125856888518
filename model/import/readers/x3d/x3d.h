// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Reads VRML97 and X3D, in XML or in the classic encoding.
Result<RawMeshes> readX3d(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
