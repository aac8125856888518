// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_module.h"

#include <dlfcn.h>

#include <system_error>

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
  const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path();
  fs::path file = folder / moduleFile;
  if (!fs::exists(file, none))
    file = folder.parent_path() / "lib/sline" / moduleFile;
  if (!fs::exists(file, none))
    return absent("there is no " + file.string());
  // It stays loaded: libraries below it do not like to go.
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    const char* reason = dlerror();
    return absent(reason ? reason : "no reason is said");
  }
  const auto entry = reinterpret_cast<PixelModuleEntry>(dlsym(library, pixelModuleEntryName));
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
