// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/base/result.h"
#include "model/camera/camera.h"

namespace sline::cli {

/// Reads a camera as `model::parseCamera` describes it. Millimetres in LPS.
Result<model::Camera> readCamera(const std::filesystem::path& file);

}  // namespace sline::cli
