// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/straight_image.h"

#include <cstring>

namespace sline::widgets {

render::Image straightImage(const QImage& picture) {
  const QImage straight = picture.convertToFormat(QImage::Format_RGBA8888);
  render::Image image{.width = straight.width(), .height = straight.height(), .rgba = {}};
  const std::size_t row = std::size_t(4) * std::size_t(image.width);
  image.rgba.resize(row * std::size_t(image.height));
  for (int y = 0; y < image.height; ++y)
    std::memcpy(&image.rgba[row * std::size_t(y)], straight.constScanLine(y), row);
  return image;
}

}  // namespace sline::widgets
