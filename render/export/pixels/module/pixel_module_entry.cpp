// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include "render/export/pixels/module/pixel_module_parts.h"

namespace sline::render {

namespace {

class OpenImageIoModule : public PixelModule {
 public:
  Result<std::unique_ptr<RowFile>> rows(PixelKind kind, const PixelLayout& layout,
                                        const PixelMarks& marks,
                                        std::unique_ptr<ByteTarget> target) const override {
    return outputRows(kind, layout, marks, std::move(target));
  }
  Result<PixelRows> read(std::string_view bytes, const PictureLimits& limits) const override {
    return inputPicture(bytes, limits);
  }
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const PixelModule* slinePixelModule(
    const char* programVersion) {
  static const OpenImageIoModule module;
  return std::string_view(programVersion) == SLINE_VERSION ? &module : nullptr;
}

}  // namespace sline::render
