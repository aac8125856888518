// SPDX-License-Identifier: Apache-2.0
#include <webp/encode.h>
#include <webp/mux.h>

#include <cerrno>
#include <cmath>
#include <cstdio>

#include "render/export/encoding/xmp_packet.h"
#include "render/export/motion/film_sink.h"

namespace sline::render {

namespace {

class WebpSink : public FilmSink {
 public:
  WebpSink(std::filesystem::path file, const FilmShape& shape)
      : m_file(std::move(file)), m_shape(shape) {}
  ~WebpSink() override {
    if (m_encoder)
      WebPAnimEncoderDelete(m_encoder);
    if (m_stream)
      std::fclose(m_stream);
  }

  Status begin() {
    m_stream = std::fopen(m_file.c_str(), "wb");
    if (!m_stream)
      return filmNotWritten(m_file, errno);
    WebPAnimEncoderOptions options;
    // A loop count of 0 means forever.
    if (!WebPAnimEncoderOptionsInit(&options) || !WebPConfigInit(&m_config))
      return failed("this is another version of libwebp than Sline was built for");
    options.kmin = m_shape.framesPerSecond;
    options.kmax = 2 * m_shape.framesPerSecond;
    // For thin lines on an even ground; chroma is kept sharp, as coloured lines would grow pale.
    m_config.quality = 85.0f;
    m_config.method = 3;
    m_config.use_sharp_yuv = 1;
    m_config.thread_level = 1;
    m_encoder = WebPAnimEncoderNew(m_shape.size.x, m_shape.size.y, &options);
    return m_encoder ? Status(Unit{}) : failed("there is too little memory");
  }

  Status add(const Image& frame) override {
    WebPPicture picture;
    if (!WebPPictureInit(&picture))
      return failed("this is another version of libwebp than Sline was built for");
    picture.use_argb = 1;
    picture.width = frame.width;
    picture.height = frame.height;
    const bool added = WebPPictureImportRGBA(&picture, frame.rgba.data(), 4 * frame.width) &&
                       WebPAnimEncoderAdd(m_encoder, &picture, timeOf(m_added), &m_config);
    WebPPictureFree(&picture);
    ++m_added;
    return added ? Status(Unit{}) : failed(WebPAnimEncoderGetError(m_encoder));
  }

  Status finish() override {
    WebPData film;
    WebPDataInit(&film);
    const bool assembled = WebPAnimEncoderAdd(m_encoder, nullptr, timeOf(m_added), nullptr) &&
                           WebPAnimEncoderAssemble(m_encoder, &film);
    if (!assembled)
      return failed(WebPAnimEncoderGetError(m_encoder));
    const bool credited = addCredit(film);
    const bool written = credited && std::fwrite(film.bytes, 1, film.size, m_stream) == film.size;
    WebPDataClear(&film);
    if (!credited)
      return failed("there is too little memory");
    const bool flushed = std::fclose(std::exchange(m_stream, nullptr)) == 0;
    return written && flushed ? Status(Unit{}) : filmNotWritten(m_file, errno);
  }

 private:
  /// Adds the credit as XMP, in a chunk of its own.
  bool addCredit(WebPData& film) const {
    const std::string xmp = xmpPacket(m_shape.credit);
    if (xmp.empty())
      return true;
    const std::unique_ptr<WebPMux, void (*)(WebPMux*)> mux(WebPMuxCreate(&film, 0), WebPMuxDelete);
    const WebPData chunk{reinterpret_cast<const std::uint8_t*>(xmp.data()), xmp.size()};
    WebPData whole;
    WebPDataInit(&whole);
    if (!mux || WebPMuxSetChunk(mux.get(), "XMP ", &chunk, 0) != WEBP_MUX_OK ||
        WebPMuxAssemble(mux.get(), &whole) != WEBP_MUX_OK)
      return false;
    WebPDataClear(&film);
    film = whole;
    return true;
  }
  /// Returns when the frame begins, in milliseconds; rounding does not add up.
  int timeOf(int frame) const {
    return int(std::lround(1000.0 * double(frame) / double(m_shape.framesPerSecond)));
  }
  Error failed(const std::string& reason) const {
    return {.file = m_file.string(),
            .reason = "the film cannot be made: " + reason,
            .remedy = "Make it smaller, or of another kind"};
  }

  std::filesystem::path m_file;
  FilmShape m_shape;
  WebPConfig m_config{};
  WebPAnimEncoder* m_encoder = nullptr;
  std::FILE* m_stream = nullptr;
  int m_added = 0;
};

}  // namespace

NewSink webpSink(const std::filesystem::path& file, const FilmShape& shape) {
  auto sink = std::make_unique<WebpSink>(file, shape);
  TRY(sink->begin());
  return std::unique_ptr<FilmSink>(std::move(sink));
}

}  // namespace sline::render
