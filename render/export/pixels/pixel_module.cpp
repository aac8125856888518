// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_module.h"

#include <system_error>

#include "model/disk/process.h"

namespace sline::render {

namespace fs = std::filesystem;

namespace {

constexpr const char* moduleFile = "libsline-pixels.so";

Error absent(const std::string& reason) {
  return {.file = moduleFile,
          .reason = "the part of the program for pictures of this kind cannot be loaded: " + reason,
          .remedy =
              "Install OpenImageIO (on Debian the package libopenimageio2.4) and this part, "
              "or choose PNG"};
}

Result<const PixelModule*> loaded() {
  std::error_code none;
  const fs::path folder = model::programFile().parent_path();
  fs::path file = folder / moduleFile;
  if (!fs::exists(file, none))
    file = folder.parent_path() / "lib/sline" / moduleFile;
  if (!fs::exists(file, none))
    return absent("there is no " + file.string());
  const Result<void*> function = model::functionOf(file, pixelModuleEntryName);
  if (!function.ok())
    return absent(function.error().reason);
  const auto entry = reinterpret_cast<PixelModuleEntry>(*function);
  const PixelModule* module = entry ? entry(SLINE_VERSION) : nullptr;
  return module ? Result<const PixelModule*>(module)
                : absent(file.string() + " belongs to another version");
}

}  // namespace

Result<const PixelModule*> pixelModule() {
  static const Result<const PixelModule*> module = loaded();
  return module;
}

}  // namespace sline::render
