// SPDX-License-Identifier: Apache-2.0
#include <gif_lib.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

#include "render/export/motion/film_sink.h"

namespace sline::render {

namespace {

constexpr int clear = GifPalette::mostColours;  // an index without a colour
constexpr int mostGifFramesPerSecond = 50;  // programs show shorter frames for a tenth of a second

struct FrameRect {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
};

class GifSink : public FilmSink {
 public:
  GifSink(std::filesystem::path file, const FilmShape& shape, GifPalette palette)
      : m_file(std::move(file)), m_shape(shape), m_palette(std::move(palette)) {}
  ~GifSink() override {
    if (m_gif)
      EGifCloseFile(m_gif, nullptr);
    if (m_stream)
      std::fclose(m_stream);
  }

  Status begin() {
    m_stream = std::fopen(m_file.c_str(), "wb");
    if (!m_stream)
      return filmNotWritten(m_file, errno);
    m_gif = EGifOpen(m_stream, write, nullptr);
    if (!m_gif)
      return broken();
    ColorMapObject* colours = GifMakeMapObject(256, nullptr);
    if (!colours)
      return broken();
    for (std::size_t i = 0; i < m_palette.colours().size(); ++i) {
      const GifPalette::Rgb& c = m_palette.colours()[i];
      colours->Colors[i] = {c[0], c[1], c[2]};
    }
    EGifSetGifVersion(m_gif, true);
    const bool described =
        EGifPutScreenDesc(m_gif, m_shape.size.x, m_shape.size.y, 8, 0, colours) == GIF_OK;
    GifFreeMapObject(colours);
    // Repeats forever (Netscape's extension, which all programs know).
    const bool begun = described &&
                       EGifPutExtensionLeader(m_gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
                       EGifPutExtensionBlock(m_gif, 11, "NETSCAPE2.0") == GIF_OK &&
                       EGifPutExtensionBlock(m_gif, 3, "\1\0\0") == GIF_OK &&
                       EGifPutExtensionTrailer(m_gif) == GIF_OK;
    return begun && putCredit() ? Status(Unit{}) : broken();
  }

  Status add(const Image& frame) override {
    std::vector<std::uint8_t> pixels = indicesOf(frame);
    const FrameRect place = m_shape.transparent || m_before.empty()
                                ? FrameRect{0, 0, m_shape.size.x, m_shape.size.y}
                                : changed(pixels);
    const bool added = describe(place) && putLines(pixels, place);
    m_before = std::move(pixels);
    ++m_added;
    return added ? Status(Unit{}) : broken();
  }

  Status finish() override {
    const bool closed = EGifCloseFile(std::exchange(m_gif, nullptr), nullptr) == GIF_OK;
    const bool flushed = std::fclose(std::exchange(m_stream, nullptr)) == 0;
    return closed && flushed ? Status(Unit{}) : broken();
  }

 private:
  static int write(GifFileType* gif, const GifByteType* bytes, int count) {
    return int(std::fwrite(bytes, 1, std::size_t(count), static_cast<FILE*>(gif->UserData)));
  }
  Error broken() const { return filmNotWritten(m_file, errno ? errno : EIO); }

  /// Writes the credit as a comment, in UTF-8; GIF has no other place for it.
  bool putCredit() {
    const ExportCredit& credit = m_shape.credit;
    std::string comment = credit.author.empty() ? "" : "Author: " + credit.author;
    if (!credit.copyright.empty())
      comment += (comment.empty() ? "Copyright: " : "\nCopyright: ") + credit.copyright;
    if (!credit.description.empty())
      comment += (comment.empty() ? "" : "\n") + credit.description;
    return comment.empty() || EGifPutComment(m_gif, comment.c_str()) == GIF_OK;
  }

  std::vector<std::uint8_t> indicesOf(const Image& frame) {
    std::vector<std::uint8_t> pixels;
    pixels.reserve(frame.rgba.size() / 4);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x) {
        const std::uint8_t* p =
            &frame.rgba[4 * (std::size_t(y) * std::size_t(frame.width) + std::size_t(x))];
        pixels.push_back(m_shape.transparent && p[3] < 128
                             ? std::uint8_t(clear)
                             : m_palette.index({p[0], p[1], p[2]}, x, y));
      }
    return pixels;
  }

  std::size_t at(int x, int y) const {
    return std::size_t(y) * std::size_t(m_shape.size.x) + std::size_t(x);
  }

  /// Returns the smallest part of the frame that differs from the one before; a single pixel where
  /// nothing differs, as each frame needs one.
  FrameRect changed(const std::vector<std::uint8_t>& pixels) const {
    int left = m_shape.size.x;
    int right = -1;
    int top = m_shape.size.y;
    int bottom = -1;
    for (int y = 0; y < m_shape.size.y; ++y)
      for (int x = 0; x < m_shape.size.x; ++x)
        if (pixels[at(x, y)] != m_before[at(x, y)]) {
          left = std::min(left, x);
          right = std::max(right, x);
          top = std::min(top, y);
          bottom = y;
        }
    return right < 0 ? FrameRect{0, 0, 1, 1}
                     : FrameRect{left, top, right - left + 1, bottom - top + 1};
  }

  /// Returns how long the frame is shown, in hundredths of a second; rounding does not add up.
  int delay() const {
    const auto until = [this](int frame) {
      return (200 * frame + m_shape.framesPerSecond) / (2 * m_shape.framesPerSecond);
    };
    return until(m_added + 1) - until(m_added);
  }

  bool describe(const FrameRect& place) {
    GraphicsControlBlock control{};
    control.DisposalMode = m_shape.transparent ? DISPOSE_BACKGROUND : DISPOSE_DO_NOT;
    control.UserInputFlag = false;
    control.DelayTime = delay();
    control.TransparentColor = clear;
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    return EGifPutExtension(m_gif, GRAPHICS_EXT_FUNC_CODE, 4, bytes.data()) == GIF_OK &&
           EGifPutImageDesc(m_gif, place.left, place.top, place.width, place.height, false,
                            nullptr) == GIF_OK;
  }

  /// Writes the lines; unchanged pixels are left clear, which packs better.
  bool putLines(const std::vector<std::uint8_t>& pixels, const FrameRect& place) {
    const bool onBefore = !m_shape.transparent && !m_before.empty();
    std::vector<GifPixelType> line(std::size_t(place.width));
    for (int y = place.top; y < place.top + place.height; ++y) {
      for (int x = 0; x < place.width; ++x) {
        const std::size_t i = at(place.left + x, y);
        line[std::size_t(x)] =
            onBefore && pixels[i] == m_before[i] ? GifPixelType(clear) : pixels[i];
      }
      if (EGifPutLine(m_gif, line.data(), place.width) != GIF_OK)
        return false;
    }
    return true;
  }

  std::filesystem::path m_file;
  FilmShape m_shape;
  GifPalette m_palette;
  std::FILE* m_stream = nullptr;
  GifFileType* m_gif = nullptr;
  std::vector<std::uint8_t> m_before;
  int m_added = 0;
};

}  // namespace

NewSink gifSink(const std::filesystem::path& file, const FilmShape& shape, GifPalette palette) {
  if (shape.framesPerSecond > mostGifFramesPerSecond)
    return Error{.file = file.string(),
                 .reason = "GIF films show at most 50 frames per second",
                 .remedy = "Choose 50 or fewer, or another kind of film"};
  auto sink = std::make_unique<GifSink>(file, shape, std::move(palette));
  TRY(sink->begin());
  return std::unique_ptr<FilmSink>(std::move(sink));
}

}  // namespace sline::render
