// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/pixels/pixel_module.h"

namespace sline::render {

/// These implement the functions of `PixelModule`; see there.
Result<std::unique_ptr<RowFile>> outputRows(PixelKind kind, const PixelLayout& layout,
                                            const PixelMarks& marks,
                                            std::unique_ptr<ByteTarget> target);
Result<PixelRows> inputPicture(std::string_view bytes, const PictureLimits& limits);

}  // namespace sline::render
