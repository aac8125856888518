// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/camera_file.h"

#include <string>

#include "model/disk/whole_file.h"
#include "model/scene_json/camera_json.h"

namespace sline::cli {

Result<model::Camera> readCamera(const std::filesystem::path& file) {
  const std::string text = TRY(model::readText(file, 1 << 20));
  Result<model::Camera> camera = model::parseCamera(text);
  if (camera.ok())
    return camera;
  Error error = camera.error();
  error.file = file.string();
  return error;
}

}  // namespace sline::cli
