// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "model/base/result.h"
#include "model/scene/camera.h"

namespace sline::cli {

/// {"projection":"perspective","eye":[x,y,z],"target":[x,y,z],"up":[x,y,z],"fovy_deg":30}, or
/// "projection":"orthographic" with "height_mm". Millimetres in LPS. eye and target are needed;
/// projection, up (the head), fovy_deg and height_mm have the defaults of model::Camera; keys that
/// are not known are refused, so that a typing error shows. The camera is without fault.
Result<model::Camera> parseCamera(std::string_view json);
Result<model::Camera> readCamera(const std::filesystem::path& file);

}  // namespace sline::cli
