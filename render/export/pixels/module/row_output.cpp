// SPDX-License-Identifier: Apache-2.0
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <vector>

#include "render/export/encoding/byte_order.h"
#include "render/export/pixels/module/pixel_module_parts.h"

namespace sline::render {

namespace {

const char* formatOf(PixelKind kind) {
  switch (kind) {
    case PixelKind::tiff:
      return "tiff";
    case PixelKind::exr:
      return "openexr";
    case PixelKind::jpeg:
      return "jpeg";
    case PixelKind::jp2:
      return "jpeg2000";
    case PixelKind::png:
    case PixelKind::webp:
      break;
  }
  return "";
}

/// Passes on what a library writes through a C file. The library's writers never see a failure, at
/// which libjpeg ends the program: the first failure is kept, and everything that follows is
/// dropped.
class Sink {
 public:
  explicit Sink(std::unique_ptr<ByteTarget> target) : m_target(std::move(target)) {
    const cookie_io_functions_t functions{
        .read = nullptr, .write = &Sink::write, .seek = &Sink::seek, .close = nullptr};
    m_file = fopencookie(this, "w", functions);
  }
  ~Sink() {
    if (m_file)
      std::fclose(m_file);
  }
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  std::FILE* file() const { return m_file; }
  const std::optional<Error>& failure() const { return m_failure; }

  /// Returns the status of everything written so far; `more` is written after it.
  Status close(std::string_view more) {
    std::fflush(m_file);
    m_at = m_end;
    put(more);
    return m_failure ? Status(*m_failure) : m_target->close();
  }

 private:
  static ssize_t write(void* self, const char* bytes, std::size_t count) {
    static_cast<Sink*>(self)->put({bytes, count});
    return ssize_t(count);
  }
  static int seek(void* self, off64_t* offset, int whence) {
    auto& sink = *static_cast<Sink*>(self);
    const auto from = std::int64_t(whence == SEEK_SET   ? 0
                                   : whence == SEEK_CUR ? sink.m_at
                                                        : sink.m_end);
    if (from + *offset < 0)
      return -1;
    sink.m_at = std::uint64_t(from + *offset);
    *offset = off64_t(sink.m_at);
    return 0;
  }
  void put(std::string_view bytes) {
    if (!m_failure && !bytes.empty())
      if (const Status written = m_target->write(m_at, bytes); !written.ok())
        m_failure = written.error();
    m_at += bytes.size();
    m_end = std::max(m_end, m_at);
  }

  std::unique_ptr<ByteTarget> m_target;
  std::FILE* m_file = nullptr;
  std::uint64_t m_at = 0;
  std::uint64_t m_end = 0;
  std::optional<Error> m_failure;
};

/// Returns a box of JP2 files that names its content by a number (ISO/IEC 15444-1, I.7.2): that of
/// XMP.
std::string xmpBox(const std::string& xmp) {
  static constexpr std::string_view number(
      "\xBE\x7A\xCF\xCB\x97\xA9\x42\xE8\x9C\x71\x99\x94\x91\xE3\xAF\xAC", 16);
  return bigEndian(8 + number.size() + xmp.size(), 4) + "uuid" + std::string(number) + xmp;
}

class OutputRows : public RowFile {
 public:
  OutputRows(PixelKind kind, const PixelLayout& layout, PixelMarks marks,
             std::unique_ptr<ByteTarget> target)
      : m_kind(kind), m_layout(layout), m_marks(std::move(marks)), m_sink(std::move(target)) {}

  Status open() {
    m_output = OIIO::ImageOutput::create(formatOf(m_kind));
    if (!m_output)
      return failed(OIIO::geterror());
    if (!m_sink.file())
      return failed("no memory is left");
    m_stream.emplace(m_sink.file(), OIIO::Filesystem::IOProxy::Write);
    // The name belongs to no file; without its ending JPEG 2000 becomes a bare stream.
    return m_output->set_ioproxy(&*m_stream) && m_output->open("picture.jp2", spec())
               ? Status(Unit{})
               : failed(m_output->geterror());
  }

  Status add(std::span<const std::byte> rows) override {
    const int count = int(rows.size() / m_layout.rowBytes());
    if (count == 0)
      return Unit{};
    const void* pixels = rows.data();
    if (m_layout.bits == 1)
      pixels = spreadBits(rows);
    else if (m_kind == PixelKind::jp2 && m_layout.channels == 2)
      pixels = spreadGrey(rows);
    const bool written = m_output->write_scanlines(m_row, m_row + count, 0, typeOfRows(), pixels);
    m_row += count;
    return written && !m_output->has_error() && !m_sink.failure() ? Status(Unit{})
                                                                  : failed(m_output->geterror());
  }

  Status finish() override {
    // JPEG 2000 reports success even when it has an error.
    if (!m_output->close() || m_output->has_error() || m_sink.failure())
      return failed(m_output->geterror());
    const bool boxed = m_kind == PixelKind::jp2 && !m_marks.xmp.empty();
    return m_sink.close(boxed ? xmpBox(m_marks.xmp) : std::string());
  }

 private:
  Status failed(const std::string& reason) const {
    if (m_sink.failure())
      return *m_sink.failure();
    return Error{.reason = "the picture cannot be written: " + reason,
                 .remedy = "Choose a smaller picture or another kind of file"};
  }

  /// Returns single bits as the library takes them: a byte each.
  const void* spreadBits(std::span<const std::byte> rows) {
    const auto width = std::size_t(m_layout.width);
    const std::size_t length = m_layout.rowBytes();
    m_spread.resize(rows.size() / length * width);
    for (std::size_t i = 0; i < m_spread.size(); ++i) {
      const std::size_t x = i % width;
      const auto byte = std::to_integer<unsigned>(rows[i / width * length + x / 8]);
      m_spread[i] = std::byte((byte >> (7 - x % 8)) & 1 ? 255 : 0);
    }
    return m_spread.data();
  }

  /// Returns grey and alpha as colour and alpha, where the library knows no other layout.
  const void* spreadGrey(std::span<const std::byte> rows) {
    const auto size = std::size_t(m_layout.bits / 8);
    m_spread.clear();
    for (std::size_t at = 0; at < rows.size(); at += 2 * size)
      for (const std::size_t part : {0, 0, 0, 1})
        m_spread.insert(m_spread.end(), rows.begin() + std::ptrdiff_t(at + part * size),
                        rows.begin() + std::ptrdiff_t(at + (part + 1) * size));
    return m_spread.data();
  }

  OIIO::TypeDesc typeOfRows() const {
    return m_layout.bits == 32   ? OIIO::TypeDesc::FLOAT
           : m_layout.bits == 16 ? OIIO::TypeDesc::UINT16
                                 : OIIO::TypeDesc::UINT8;
  }

  OIIO::ImageSpec spec() const {
    const bool exr = m_kind == PixelKind::exr;
    const auto type = OIIO::TypeDesc(exr ? OIIO::TypeDesc::HALF : typeOfRows());
    const bool greyInColour = m_kind == PixelKind::jp2 && m_layout.channels == 2;
    OIIO::ImageSpec spec(m_layout.width, m_layout.height, greyInColour ? 4 : m_layout.channels,
                         type);
    if (m_layout.isGrey() && !greyInColour)
      spec.channelnames[0] = "Y";
    if (m_layout.hasAlpha()) {
      spec.channelnames.back() = "A";
      spec.alpha_channel = spec.nchannels - 1;
      if (!exr)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    }
    addPacking(spec);
    if (exr) {
      constexpr std::array<float, 8> srgb{0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};
      spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, int(srgb.size())),
                     srgb.data());
    } else if (m_kind != PixelKind::jp2) {  // JP2 states it by a number
      spec.attribute("ICCProfile",
                     OIIO::TypeDesc(OIIO::TypeDesc::UINT8, int(m_marks.profile.size())),
                     m_marks.profile.data());
    }
    addDescription(spec);
    return spec;
  }

  void addPacking(OIIO::ImageSpec& spec) const {
    switch (m_kind) {
      case PixelKind::tiff: {
        constexpr std::size_t stripBytes = 1 << 18;
        spec.attribute("compression", "zip");
        spec.attribute("tiff:write_exif", 0);  // for photographs; its writer also wants to read
        spec.attribute("oiio:BitsPerSample", m_layout.bits);
        spec.attribute("tiff:RowsPerStrip",
                       int(std::max<std::size_t>(stripBytes / m_layout.rowBytes(), 1)));
        if (double(m_layout.rowBytes()) * m_layout.height > 4.0e9)
          spec.attribute("tiff:bigtiff", 1);
        break;
      }
      case PixelKind::exr:
        spec.attribute("compression", "zip");  // every decoder has it
        break;
      case PixelKind::jpeg:
        // Thin coloured lines do not survive colours at half the resolution.
        spec.attribute("compression", "jpeg:95");
        spec.attribute("jpeg:subsampling", "4:4:4");
        break;
      case PixelKind::jp2:  // exact, unless told otherwise
      case PixelKind::webp:
      case PixelKind::png:
        break;
    }
  }

  void addDescription(OIIO::ImageSpec& spec) const {
    if (m_layout.dpi > 0.0f) {
      spec.attribute("XResolution", m_layout.dpi);
      spec.attribute("YResolution", m_layout.dpi);
      spec.attribute("ResolutionUnit", "in");
    }
    spec.attribute("Software", m_marks.software);
    if (!m_layout.credit.author.empty())
      spec.attribute("Artist", m_layout.credit.author);
    if (!m_layout.credit.copyright.empty())
      spec.attribute("Copyright", m_layout.credit.copyright);
    if (!m_layout.credit.description.empty())
      spec.attribute("ImageDescription", m_layout.credit.description);
    // By default writers put in the time of day. EXR's takes an empty text for none; the others
    // take anything that is not text for none.
    if (m_kind == PixelKind::exr)
      spec.attribute("DateTime", "");
    else
      spec.attribute("DateTime", 0);
  }

  PixelKind m_kind;
  PixelLayout m_layout;
  PixelMarks m_marks;
  Sink m_sink;
  std::optional<OIIO::Filesystem::IOFile> m_stream;
  std::unique_ptr<OIIO::ImageOutput> m_output;  ///< must be destroyed before what it writes to
  std::vector<std::byte> m_spread;
  int m_row = 0;
};

}  // namespace

Result<std::unique_ptr<RowFile>> outputRows(PixelKind kind, const PixelLayout& layout,
                                            const PixelMarks& marks,
                                            std::unique_ptr<ByteTarget> target) {
  auto rows = std::make_unique<OutputRows>(kind, layout, marks, std::move(target));
  TRY(rows->open());
  return std::unique_ptr<RowFile>(std::move(rows));
}

}  // namespace sline::render
