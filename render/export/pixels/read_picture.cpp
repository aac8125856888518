// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/read_picture.h"

#include "model/disk/whole_file.h"

namespace sline::render {

Result<PixelRows> readPicture(const std::filesystem::path& file, const PictureLimits& limits) {
  const std::string bytes = TRY(model::readText(file, limits.fileBytes));
  const PixelModule* const module = TRY(pixelModule());
  Result<PixelRows> rows = module->read(bytes, limits);
  if (rows.ok())
    return rows;
  Error error = rows.error();
  error.file = file.string();
  return error;
}

}  // namespace sline::render
