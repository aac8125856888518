// SPDX-License-Identifier: Apache-2.0
// TIFF 6.0 in deflated strips, and BigTIFF where four gigabytes are not enough.
#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "model/base/parallel.h"
#include "model/files/whole_file.h"
#include "render/export/pixels/byte_order.h"
#include "render/export/pixels/colour_profile.h"
#include "render/export/pixels/deflate.h"
#include "render/export/pixels/tiff_fields.h"
#include "render/export/xmp_packet.h"

namespace sline::render {

namespace {

constexpr std::size_t stripBytes = 1 << 18;

class TiffFile : public RowFile {
 public:
  TiffFile(const PixelLayout& layout, std::unique_ptr<model::GrowingFile> file)
      : m_layout(layout),
        m_file(std::move(file)),
        m_rowsPerStrip(std::max<std::size_t>(stripBytes / layout.rowBytes(), 1)),
        m_big(double(layout.rowBytes()) * layout.height > 4.0e9) {}

  Status add(std::span<const std::byte> rows) override {
    if (Status begun = begin(); !begun.ok())
      return begun;
    m_waiting.insert(m_waiting.end(), rows.begin(), rows.end());
    return writeStrips(false);
  }

  Status finish() override {
    if (Status begun = begin(); !begun.ok())
      return begun;
    if (Status written = writeStrips(true); !written.ok())
      return written;
    return writeDirectory();
  }

 private:
  Status begin() {
    if (std::exchange(m_begun, true))
      return Unit{};
    // Where the directory is gets known at the end.
    return m_file->add(m_big ? "II" + littleEndian(43, 2) + littleEndian(8, 2) +
                                   littleEndian(0, 2) + littleEndian(0, 8)
                             : "II" + littleEndian(42, 2) + littleEndian(0, 4));
  }

  Status writeStrips(bool last) {
    const std::size_t strip = m_rowsPerStrip * m_layout.rowBytes();
    const std::size_t whole = m_waiting.size() / strip;
    const std::size_t count = whole + (last && m_waiting.size() % strip > 0 ? 1 : 0);
    std::vector<std::string> deflated(count);
    parallelFor(count, 1, [&](std::size_t i) {
      const std::span<std::byte> all(m_waiting);
      const std::span<std::byte> rows =
          all.subspan(i * strip, std::min(strip, all.size() - i * strip));
      predict(rows);
      deflated[i] = zlibStream(rows);
    });
    for (const std::string& bytes : deflated) {
      m_offsets.push_back(m_file->size());
      m_lengths.push_back(bytes.size());
      if (Status written = m_file->add(bytes); !written.ok())
        return written;
    }
    m_waiting.erase(m_waiting.begin(),
                    m_waiting.begin() + std::ptrdiff_t(std::min(count * strip, m_waiting.size())));
    return Unit{};
  }

  bool predicts() const { return m_layout.bits > 1; }

  /// Horizontal differences (TIFF 6.0, section 14), from each row's end on.
  void predict(std::span<std::byte> rows) const {
    if (!predicts())
      return;
    const auto channels = std::size_t(m_layout.channels);
    for (std::size_t row = 0; row < rows.size(); row += m_layout.rowBytes()) {
      std::byte* bytes = rows.data() + row;
      const std::size_t count = std::size_t(m_layout.width) * channels;
      for (std::size_t i = count; i-- > channels;)
        if (m_layout.bits == 8) {
          bytes[i] = std::byte(std::uint8_t(std::to_integer<int>(bytes[i]) -
                                            std::to_integer<int>(bytes[i - channels])));
        } else {
          std::uint16_t value = 0;
          std::uint16_t before = 0;
          std::memcpy(&value, bytes + 2 * i, 2);
          std::memcpy(&before, bytes + 2 * (i - channels), 2);
          value = std::uint16_t(value - before);
          std::memcpy(bytes + 2 * i, &value, 2);
        }
    }
  }

  TiffField stripField(std::uint16_t tag, const std::vector<std::uint64_t>& values) const {
    TiffField field{tag, m_big ? TiffType::long8 : TiffType::longs, values.size(), {}};
    for (const std::uint64_t value : values)
      field.data += littleEndian(value, m_big ? 8 : 4);
    return field;
  }

  std::vector<TiffField> fields() const {
    std::vector<TiffField> list = descriptiveFields(m_layout);
    list.insert(list.end(),
                {longField(256, std::uint64_t(m_layout.width)),
                 longField(257, std::uint64_t(m_layout.height)),
                 shortField(258, std::vector<unsigned>(std::size_t(m_layout.channels),
                                                       unsigned(m_layout.bits))),
                 shortField(259, {8}),  // deflate
                 shortField(262, {m_layout.isGrey() ? 1u : 2u}), stripField(273, m_offsets),
                 shortField(274, {1}), shortField(277, {unsigned(m_layout.channels)}),
                 longField(278, m_rowsPerStrip), stripField(279, m_lengths), shortField(284, {1})});
    if (predicts())
      list.push_back(shortField(317, {2}));
    if (m_layout.hasAlpha())
      list.push_back(shortField(338, {2}));  // straight
    if (const std::string xmp = xmpPacket(m_layout.credit); !xmp.empty())
      list.push_back({700, TiffType::octets, xmp.size(), xmp});
    const std::string profile = m_layout.isGrey() ? greyProfile() : srgbProfile();
    list.push_back({34675, TiffType::bytes, profile.size(), profile});
    return list;
  }

  Status writeDirectory() {
    const TiffDirectory directory = tiffDirectory(fields(), m_file->size(), m_big);
    if (Status written = m_file->add(directory.bytes); !written.ok())
      return written;
    const Status pointed =
        m_file->replace(m_big ? 8 : 4, littleEndian(directory.at, m_big ? 8 : 4));
    return pointed.ok() ? m_file->close() : pointed;
  }

  PixelLayout m_layout;
  std::unique_ptr<model::GrowingFile> m_file;
  std::size_t m_rowsPerStrip;
  bool m_big;
  bool m_begun = false;
  std::vector<std::byte> m_waiting;
  std::vector<std::uint64_t> m_offsets;
  std::vector<std::uint64_t> m_lengths;
};

}  // namespace

Result<std::unique_ptr<RowFile>> tiffRows(const PixelLayout& layout,
                                          const std::filesystem::path& file) {
  Result<std::unique_ptr<model::GrowingFile>> growing = model::GrowingFile::create(file);
  if (!growing.ok())
    return growing.error();
  return std::unique_ptr<RowFile>(std::make_unique<TiffFile>(layout, std::move(*growing)));
}

}  // namespace sline::render
