// SPDX-License-Identifier: Apache-2.0
// Writes lossless WebP pictures through libwebp. OpenImageIO's writer halves the resolution of
// colours even then: coloured lines were off by up to 75 of 255.
#include <webp/encode.h>
#include <webp/mux.h>

#include <memory>
#include <vector>

#include "model/disk/whole_file.h"
#include "render/export/encoding/xmp_packet.h"
#include "render/export/pixels/pixel_kind.h"

namespace sline::render {

namespace {

/// A file that libwebp packs as a whole.
class WebpFile : public RowFile {
 public:
  WebpFile(const PixelLayout& layout, std::filesystem::path path,
           std::unique_ptr<model::GrowingFile> file)
      : m_layout(layout), m_path(std::move(path)), m_file(std::move(file)) {
    m_pixels.reserve(layout.rowBytes() * std::size_t(layout.height));
  }

  Status add(std::span<const std::byte> rows) override {
    m_pixels.insert(m_pixels.end(), rows.begin(), rows.end());
    return Unit{};
  }

  Status finish() override {
    WebPMemoryWriter packed;
    WebPMemoryWriterInit(&packed);
    const std::unique_ptr<WebPMemoryWriter, decltype(&WebPMemoryWriterClear)> owner(
        &packed, &WebPMemoryWriterClear);
    TRY(pack(packed));
    WebPData whole{packed.mem, packed.size};
    const std::string xmp = xmpPacket(m_layout.credit);
    if (xmp.empty())
      return write(whole);
    const std::unique_ptr<WebPMux, decltype(&WebPMuxDelete)> mux(WebPMuxCreate(&whole, 0),
                                                                 &WebPMuxDelete);
    const WebPData chunk{reinterpret_cast<const std::uint8_t*>(xmp.data()), xmp.size()};
    WebPData credited{};
    if (!mux || WebPMuxSetChunk(mux.get(), "XMP ", &chunk, 0) != WEBP_MUX_OK ||
        WebPMuxAssemble(mux.get(), &credited) != WEBP_MUX_OK)
      return failed("there is too little memory");
    Status written = write(credited);
    WebPDataClear(&credited);
    return written;
  }

 private:
  Status pack(WebPMemoryWriter& packed) {
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture))
      return failed("this is another version of libwebp than Sline was built for");
    config.lossless = 1;
    config.exact = 1;
    config.thread_level = 1;
    picture.use_argb = 1;
    picture.width = m_layout.width;
    picture.height = m_layout.height;
    picture.writer = &WebPMemoryWrite;
    picture.custom_ptr = &packed;
    const auto import = m_layout.hasAlpha() ? &WebPPictureImportRGBA : &WebPPictureImportRGB;
    const bool done = import(&picture, reinterpret_cast<const std::uint8_t*>(m_pixels.data()),
                             int(m_layout.rowBytes())) &&
                      WebPEncode(&config, &picture);
    const int reason = picture.error_code;
    WebPPictureFree(&picture);
    return done ? Status(Unit{}) : failed("libwebp's error " + std::to_string(reason));
  }

  Status write(const WebPData& bytes) {
    TRY(m_file->add({reinterpret_cast<const char*>(bytes.bytes), bytes.size}));
    return m_file->close();
  }

  Error failed(const std::string& reason) const {
    return {.file = m_path.string(),
            .reason = "the picture cannot be written: " + reason,
            .remedy = "Choose a smaller picture or another kind of file"};
  }

  PixelLayout m_layout;
  std::filesystem::path m_path;
  std::unique_ptr<model::GrowingFile> m_file;
  std::vector<std::byte> m_pixels;
};

}  // namespace

Result<std::unique_ptr<RowFile>> webpRows(const PixelLayout& layout,
                                          const std::filesystem::path& file) {
  std::unique_ptr<model::GrowingFile> growing = TRY(model::GrowingFile::create(file));
  return std::unique_ptr<RowFile>(std::make_unique<WebpFile>(layout, file, std::move(growing)));
}

}  // namespace sline::render
