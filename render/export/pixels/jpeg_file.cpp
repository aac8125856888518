// SPDX-License-Identifier: Apache-2.0
// JPEG (ITU-T T.81) through libjpeg.
#include <array>
#include <cmath>
#include <csetjmp>
#include <cstdio>  // jpeglib.h wants it before
#include <optional>

#include <jpeglib.h>

#include "model/files/whole_file.h"
#include "render/export/pixels/byte_order.h"
#include "render/export/pixels/colour_profile.h"
#include "render/export/pixels/tiff_fields.h"
#include "render/export/xmp_packet.h"

namespace sline::render {

namespace {

constexpr int quality = 95;

/// libjpeg leaves a call that fails by a jump.
struct JpegErrors : jpeg_error_mgr {
  std::jmp_buf jump;
  std::array<char, JMSG_LENGTH_MAX> text;
};

void leave(j_common_ptr common) {
  auto* errors = static_cast<JpegErrors*>(common->err);
  errors->format_message(common, errors->text.data());
  std::longjmp(errors->jump, 1);
}

void sayNothing(j_common_ptr) {}

/// Where libjpeg's bytes go. After a failure they are dropped: no jump may pass what owns
/// something.
struct JpegTarget : jpeg_destination_mgr {
  explicit JpegTarget(model::GrowingFile& to);

  model::GrowingFile& file;
  std::array<JOCTET, 1 << 16> buffer;
  std::optional<Error> failure;

  void rewind() {
    next_output_byte = buffer.data();
    free_in_buffer = buffer.size();
  }
  void add(std::size_t count) {
    if (failure)
      return;
    const Status added =
        file.add(std::string_view(reinterpret_cast<const char*>(buffer.data()), count));
    if (!added.ok())
      failure = added.error();
  }
};

JpegTarget& targetOf(j_compress_ptr compress) {
  return *static_cast<JpegTarget*>(compress->dest);
}

JpegTarget::JpegTarget(model::GrowingFile& to) : jpeg_destination_mgr{}, file(to), buffer{} {
  init_destination = [](j_compress_ptr compress) { targetOf(compress).rewind(); };
  empty_output_buffer = [](j_compress_ptr compress) -> boolean {
    JpegTarget& target = targetOf(compress);
    target.add(target.buffer.size());
    target.rewind();
    return TRUE;
  };
  term_destination = [](j_compress_ptr compress) {
    JpegTarget& target = targetOf(compress);
    target.add(target.buffer.size() - target.free_in_buffer);
  };
}

std::string exifBlock(const PixelLayout& layout) {
  const TiffDirectory directory = tiffDirectory(descriptiveFields(layout), 8, false);
  return std::string("Exif\0\0II", 8) + littleEndian(42, 2) + littleEndian(directory.at, 4) +
         directory.bytes;
}

std::string xmpBlock(const ExportCredit& credit) {
  const std::string packet = xmpPacket(credit);
  return packet.empty() ? packet : std::string("http://ns.adobe.com/xap/1.0/") + '\0' + packet;
}

class JpegFile : public RowFile {
 public:
  JpegFile(const PixelLayout& layout, std::filesystem::path path,
           std::unique_ptr<model::GrowingFile> file)
      : m_layout(layout), m_path(std::move(path)), m_file(std::move(file)), m_target(*m_file) {
    m_compress.err = jpeg_std_error(&m_errors);
    m_errors.error_exit = leave;
    m_errors.output_message = sayNothing;
  }
  ~JpegFile() override { jpeg_destroy_compress(&m_compress); }
  JpegFile(const JpegFile&) = delete;
  JpegFile& operator=(const JpegFile&) = delete;

  Status open() {
    const std::string exif = exifBlock(m_layout);
    const std::string xmp = xmpBlock(m_layout.credit);
    const std::string profile = m_layout.isGrey() ? greyProfile() : srgbProfile();
    return guarded([&] {
      jpeg_create_compress(&m_compress);
      m_compress.dest = &m_target;
      setUp();
      jpeg_start_compress(&m_compress, TRUE);
      for (const std::string* block : {&exif, &xmp})
        if (!block->empty())
          jpeg_write_marker(&m_compress, JPEG_APP0 + 1, bytesOf(*block), unsigned(block->size()));
      jpeg_write_icc_profile(&m_compress, bytesOf(profile), unsigned(profile.size()));
    });
  }

  Status add(std::span<const std::byte> rows) override {
    const std::size_t length = m_layout.rowBytes();
    return guarded([&] {
      for (std::size_t at = 0; at + length <= rows.size(); at += length) {
        // libjpeg only reads the row, and does not say so.
        auto* row = reinterpret_cast<JSAMPLE*>(const_cast<std::byte*>(rows.data() + at));
        jpeg_write_scanlines(&m_compress, &row, 1);
      }
    });
  }

  Status finish() override {
    if (Status finished = guarded([this] { jpeg_finish_compress(&m_compress); }); !finished.ok())
      return finished;
    return m_file->close();
  }

 private:
  static const JOCTET* bytesOf(const std::string& text) {
    return reinterpret_cast<const JOCTET*>(text.data());
  }

  void setUp() {
    m_compress.image_width = JDIMENSION(m_layout.width);
    m_compress.image_height = JDIMENSION(m_layout.height);
    m_compress.input_components = m_layout.channels;
    m_compress.in_color_space = m_layout.isGrey() ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&m_compress);
    jpeg_set_quality(&m_compress, quality, TRUE);
    // Thin coloured lines do not survive colours at half the resolution.
    m_compress.comp_info[0].h_samp_factor = 1;
    m_compress.comp_info[0].v_samp_factor = 1;
    if (m_layout.dpi > 0.0f) {
      m_compress.density_unit = 1;  // per inch
      m_compress.X_density = UINT16(std::lround(m_layout.dpi));
      m_compress.Y_density = m_compress.X_density;
    }
  }

  /// Nothing in `call` may own anything: where libjpeg fails it does not come to its end.
  template <class Call>
  Status guarded(const Call& call) {
    if (setjmp(m_errors.jump) != 0)
      return Error{.file = m_path.string(),
                   .reason = std::string("the picture cannot be written: ") + m_errors.text.data(),
                   .remedy = "Choose a smaller picture or another kind of file"};
    call();
    return m_target.failure ? Status(*m_target.failure) : Status(Unit{});
  }

  PixelLayout m_layout;
  std::filesystem::path m_path;
  std::unique_ptr<model::GrowingFile> m_file;
  JpegTarget m_target;
  JpegErrors m_errors{};
  jpeg_compress_struct m_compress{};
};

}  // namespace

Result<std::unique_ptr<RowFile>> jpegRows(const PixelLayout& layout,
                                          const std::filesystem::path& file) {
  Result<std::unique_ptr<model::GrowingFile>> growing = model::GrowingFile::create(file);
  if (!growing.ok())
    return growing.error();
  auto rows = std::make_unique<JpegFile>(layout, file, std::move(*growing));
  if (Status opened = rows->open(); !opened.ok())
    return opened.error();
  return std::unique_ptr<RowFile>(std::move(rows));
}

}  // namespace sline::render
