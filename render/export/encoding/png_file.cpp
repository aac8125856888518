// SPDX-License-Identifier: Apache-2.0
// Writes PNG (ISO/IEC 15948:2004), deflated on all cores.
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "model/base/parallel.h"
#include "render/export/encoding/byte_order.h"
#include "render/export/encoding/colour_profile.h"
#include "render/export/encoding/deflate.h"
#include "render/export/encoding/png_chunk.h"
#include "render/export/encoding/row_file.h"
#include "render/export/encoding/xmp_packet.h"

namespace sline::render {

namespace {

constexpr std::size_t partBytes = 1 << 20;

enum class Filter : std::uint8_t { none = 0, left = 1, up = 2 };

std::string profileChunk(const std::string& profile) {
  return pngChunk(
      "iCCP", std::string("Grey") + '\0' + '\0' + zlibStream(std::as_bytes(std::span(profile))));
}

/// Returns a chunk of UTF-8 text that is not deflated; the language may be unknown.
std::string textChunk(const std::string& keyword, const std::string& text,
                      const std::string& language = {}) {
  return text.empty() ? std::string()
                      : pngChunk("iTXt", keyword + std::string(3, '\0') + language +
                                             std::string(2, '\0') + text);
}

std::string creditChunks(const ExportCredit& credit) {
  return textChunk("Author", credit.author) + textChunk("Copyright", credit.copyright) +
         textChunk("Description", credit.description, credit.descriptionLanguage) +
         textChunk("XML:com.adobe.xmp", xmpPacket(credit));
}

std::string headOf(const PixelLayout& layout) {
  static constexpr std::array<char, 5> colourTypes{0, 0, 4, 2, 6};
  std::string header =
      bigEndian(std::uint64_t(layout.width), 4) + bigEndian(std::uint64_t(layout.height), 4);
  header += char(layout.bits);
  header += colourTypes[std::size_t(layout.channels)];
  header += std::string(3, '\0');
  std::string head = std::string(pngSignature) + pngChunk("IHDR", header);
  head += layout.isGrey() ? profileChunk(greyProfile()) : pngSrgbChunks();
  if (layout.dpi > 0.0f) {
    const auto perMetre = std::uint64_t(std::lround(layout.dpi / 0.0254f));
    head += pngChunk("pHYs", bigEndian(perMetre, 4) + bigEndian(perMetre, 4) + '\x01');
  }
  head += pngChunk("tEXt", std::string("Software") + '\0' + "Sline " SLINE_VERSION);
  return head + creditChunks(layout.credit);
}

class PngFile : public RowFile {
 public:
  PngFile(const PixelLayout& layout, ByteSink sink)
      : m_layout(layout), m_sink(std::move(sink)), m_above(layout.rowBytes()) {}

  Status add(std::span<const std::byte> rows) override {
    TRY(begin());
    const std::size_t length = m_layout.rowBytes();
    const std::size_t count = rows.size() / length;
    if (count == 0)
      return Unit{};
    std::vector<std::byte> ordered(rows.begin(), rows.end());
    if (m_layout.bits == 16 && std::endian::native == std::endian::little)
      for (std::size_t i = 0; i + 1 < ordered.size(); i += 2)
        std::swap(ordered[i], ordered[i + 1]);
    std::vector<std::byte> filtered(count * (length + 1));
    parallelFor(count, 8, [&](std::size_t i) {
      const std::span all(ordered);
      const std::span<const std::byte> above =
          i == 0 ? std::span<const std::byte>(m_above) : all.subspan((i - 1) * length, length);
      filterRow(all.subspan(i * length, length), above,
                std::span(filtered).subspan(i * (length + 1), length + 1));
    });
    m_above.assign(ordered.end() - std::ptrdiff_t(length), ordered.end());
    return write(filtered);
  }

  Status finish() override {
    TRY(begin());
    return m_sink(pngChunk("IDAT", m_stream.finish()) + pngChunk("IEND", {}));
  }

 private:
  Status begin() {
    if (std::exchange(m_begun, true))
      return Unit{};
    return m_sink(headOf(m_layout));
  }

  Status write(std::span<const std::byte> filtered) {
    std::vector<std::span<const std::byte>> parts;
    for (std::size_t i = 0; i < filtered.size(); i += partBytes)
      parts.push_back(filtered.subspan(i, std::min(partBytes, filtered.size() - i)));
    for (const std::string& deflated : m_stream.add(parts))
      TRY(m_sink(pngChunk("IDAT", deflated)));
    return Unit{};
  }

  /// Chooses the filter with the smallest differences. Drawings repeat the pixels to the left or
  /// above, so these two are enough; single bits deflate best as they are.
  void filterRow(std::span<const std::byte> row, std::span<const std::byte> above,
                 std::span<std::byte> out) const {
    const std::size_t step =
        std::max<std::size_t>(std::size_t(m_layout.channels * m_layout.bits) / 8, 1);
    const auto at = [](std::span<const std::byte> bytes, std::size_t i) {
      return std::to_integer<int>(bytes[i]);
    };
    Filter filter = Filter::none;
    if (m_layout.bits > 1) {
      std::size_t left = 0;
      std::size_t up = 0;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const int before = i >= step ? at(row, i - step) : 0;
        left += std::size_t(std::abs(std::int8_t(at(row, i) - before)));
        up += std::size_t(std::abs(std::int8_t(at(row, i) - at(above, i))));
      }
      filter = up <= left ? Filter::up : Filter::left;
    }
    out[0] = std::byte(filter);
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int base = filter == Filter::up                  ? at(above, i)
                       : filter == Filter::left && i >= step ? at(row, i - step)
                                                             : 0;
      out[i + 1] = std::byte(std::uint8_t(at(row, i) - base));
    }
  }

  PixelLayout m_layout;
  ByteSink m_sink;
  std::vector<std::byte> m_above;
  DeflateStream m_stream;
  bool m_begun = false;
};

}  // namespace

std::string pngChunk(std::string_view name, std::string_view data) {
  std::string body(name);
  body += data;
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size()));
  return bigEndian(data.size(), 4) + body + bigEndian(sum, 4);
}

std::string pngSrgbChunks() {
  std::string primaries;
  for (const unsigned value : {31270u, 32900u, 64000u, 33000u, 30000u, 60000u, 15000u, 6000u})
    primaries += bigEndian(value, 4);
  return pngChunk("sRGB", std::string(1, '\0')) + pngChunk("gAMA", bigEndian(45455, 4)) +
         pngChunk("cHRM", primaries);
}

std::unique_ptr<RowFile> pngRows(const PixelLayout& layout, ByteSink sink) {
  return std::make_unique<PngFile>(layout, std::move(sink));
}

}  // namespace sline::render
