// SPDX-License-Identifier: Apache-2.0
#include "render/export/png_image.h"

#include <QBuffer>
#include <QImage>

namespace sline::render {

Result<std::string> pngOf(const Image& image) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4)
    opaque = image.rgba[i] == 255;
  const QImage pixels(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                      QImage::Format_RGBA8888);
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  const bool made = opaque ? pixels.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG")
                           : pixels.save(&buffer, "PNG");
  if (!made)
    return Error{.reason = "the PNG cannot be made", .remedy = "Make the picture smaller"};
  return png.toStdString();
}

}  // namespace sline::render
