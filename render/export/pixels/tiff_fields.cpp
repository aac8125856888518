// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/tiff_fields.h"

#include <algorithm>
#include <cmath>

#include "render/export/pixels/byte_order.h"

namespace sline::render {

namespace {

TiffField rationalField(std::uint16_t tag, double value) {
  const auto thousandths = std::uint64_t(std::llround(value * 1000.0));
  return {tag, TiffType::rational, 1, littleEndian(thousandths, 4) + littleEndian(1000, 4)};
}

}  // namespace

TiffField shortField(std::uint16_t tag, const std::vector<unsigned>& values) {
  TiffField field{tag, TiffType::shorts, values.size(), {}};
  for (const unsigned value : values)
    field.data += littleEndian(value, 2);
  return field;
}

TiffField longField(std::uint16_t tag, std::uint64_t value) {
  return {tag, TiffType::longs, 1, littleEndian(value, 4)};
}

TiffField textField(std::uint16_t tag, const std::string& text) {
  return {tag, TiffType::ascii, text.size() + 1, text + '\0'};
}

std::vector<TiffField> descriptiveFields(const PixelLayout& layout) {
  std::vector<TiffField> fields{textField(305, "Sline " SLINE_VERSION)};
  if (layout.dpi > 0.0f) {
    fields.push_back(rationalField(282, double(layout.dpi)));
    fields.push_back(rationalField(283, double(layout.dpi)));
    fields.push_back(shortField(296, {2}));  // per inch
  }
  if (!layout.credit.author.empty())
    fields.push_back(textField(315, layout.credit.author));
  if (!layout.credit.copyright.empty())
    fields.push_back(textField(33432, layout.credit.copyright));
  return fields;
}

TiffDirectory tiffDirectory(std::vector<TiffField> fields, std::uint64_t start, bool big) {
  const std::size_t word = big ? 8 : 4;
  std::sort(fields.begin(), fields.end(),
            [](const TiffField& a, const TiffField& b) { return a.tag < b.tag; });
  std::string entries = littleEndian(fields.size(), big ? 8 : 2);
  std::string aside(start % 2, '\0');
  for (const TiffField& field : fields) {
    entries += littleEndian(field.tag, 2) + littleEndian(std::uint64_t(field.type), 2) +
               littleEndian(field.count, word);
    if (field.data.size() <= word) {
      entries += field.data + std::string(word - field.data.size(), '\0');
      continue;
    }
    entries += littleEndian(start + aside.size(), word);
    aside += field.data + std::string(field.data.size() % 2, '\0');
  }
  entries += littleEndian(0, word);
  return {.bytes = aside + entries, .at = start + aside.size()};
}

}  // namespace sline::render
