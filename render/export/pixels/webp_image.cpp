// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/webp_image.h"

#include <webp/encode.h>

#include <memory>

namespace sline::render {

Result<std::string> webpOf(const Image& image, float quality) {
  const Error failed{.reason = "the picture cannot be packed as WebP",
                     .remedy = "Choose another kind of file"};
  WebPConfig config;
  WebPPicture picture;
  if (!WebPConfigPreset(&config, WEBP_PRESET_DRAWING, quality) || !WebPPictureInit(&picture))
    return failed;
  config.method = 6;
  config.use_sharp_yuv = 1;
  picture.use_argb = 1;
  picture.width = image.width;
  picture.height = image.height;
  WebPMemoryWriter packed;
  WebPMemoryWriterInit(&packed);
  const std::unique_ptr<WebPMemoryWriter, decltype(&WebPMemoryWriterClear)> owner(
      &packed, &WebPMemoryWriterClear);
  picture.writer = &WebPMemoryWrite;
  picture.custom_ptr = &packed;
  bool done = WebPPictureImportRGBA(&picture, image.rgba.data(), 4 * image.width) != 0;
  if (done) {
    constexpr std::uint32_t white = 0xffffff;
    WebPBlendAlpha(&picture, white);
    done = WebPEncode(&config, &picture) != 0;
  }
  WebPPictureFree(&picture);
  return done ? Result<std::string>(
                    std::string(reinterpret_cast<const char*>(packed.mem), packed.size))
              : failed;
}

}  // namespace sline::render
