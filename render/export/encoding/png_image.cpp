// SPDX-License-Identifier: Apache-2.0
#include "render/export/encoding/png_image.h"

#include <QBuffer>
#include <QImage>

#include "render/export/encoding/xmp_packet.h"

namespace sline::render {

Result<std::string> pngOf(const Image& image, const ExportCredit& credit) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4)
    opaque = image.rgba[i] == 255;
  QImage pixels(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                QImage::Format_RGBA8888);
  if (opaque)
    pixels = pixels.convertToFormat(QImage::Format_RGB888);
  // Keywords of the PNG specification, 11.3.3.2.
  for (const auto& [keyword, text] :
       {std::pair("Author", credit.author), std::pair("Copyright", credit.copyright),
        std::pair("XML:com.adobe.xmp", xmpPacket(credit))})
    if (!text.empty())
      pixels.setText(QLatin1String(keyword), QString::fromStdString(text));
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  if (!pixels.save(&buffer, "PNG"))
    return Error{.reason = "the PNG cannot be made", .remedy = "Make the picture smaller"};
  return png.toStdString();
}

}  // namespace sline::render
