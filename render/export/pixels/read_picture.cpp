// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/read_picture.h"

#include "model/disk/whole_file.h"

namespace sline::render {

Result<PixelRows> readPicture(const std::filesystem::path& file, const PictureLimits& limits) {
  const Result<std::string> bytes = model::readText(file, limits.fileBytes);
  if (!bytes.ok())
    return bytes.error();
  const Result<const PixelModule*> module = pixelModule();
  if (!module.ok())
    return module.error();
  Result<PixelRows> rows = (*module)->read(*bytes, limits);
  if (rows.ok())
    return rows;
  Error error = rows.error();
  error.file = file.string();
  return error;
}

}  // namespace sline::render
