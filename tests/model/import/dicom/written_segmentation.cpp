// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_segmentation.h"

namespace sline::test {

namespace {

QByteArray bitsOf(const std::vector<std::uint8_t>& pixels) {
  QByteArray bytes(qsizetype((pixels.size() + 7) / 8), '\0');
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i] != 0)
      bytes[qsizetype(i / 8)] = char(bytes[qsizetype(i / 8)] | (1 << (i % 8)));
  return bytes;
}

/// Returns one frame's bytes as they stand in the file; bits only if all frames' are whole bytes.
QByteArray bytesOf(const WrittenSegmentation& written, const std::vector<std::uint8_t>& pixels) {
  if (written.bits == 1)
    return bitsOf(pixels);
  QByteArray bytes;
  for (const std::uint8_t pixel : pixels) {
    bytes += char(pixel);
    if (written.bits == 16)
      bytes += '\0';
  }
  return bytes;
}

WrittenElement pixelsOf(const WrittenSegmentation& written) {
  std::vector<QByteArray> packed;
  std::vector<std::uint8_t> all;
  for (const WrittenFrame& frame : written.frames) {
    all.insert(all.end(), frame.pixels.begin(), frame.pixels.end());
    if (written.runLength)
      packed.push_back(runs({bytesOf(written, frame.pixels)}));
    else if (written.pack)
      packed.push_back(written.pack(frame));
  }
  if (!packed.empty())
    return pieces(packed);
  return {{0x7fe0, 0x0010}, written.bits == 16 ? "OW" : "OB", bytesOf(written, all), {}};
}

const char* typeOf(const WrittenSegmentation& written) {
  return written.labelMap ? "LABELMAP" : written.fractional ? "FRACTIONAL" : "BINARY";
}

WrittenSet code(const QByteArray& meaning) {
  return {text({0x0008, 0x0100}, "SH", "123"), text({0x0008, 0x0104}, "LO", meaning)};
}

}  // namespace

WrittenSet segmentation(const WrittenSegmentation& written) {
  const auto& id = identities();
  WrittenSet set = identifying(written.labelMap ? "1.2.840.10008.5.1.4.1.1.66.7"
                                                : "1.2.840.10008.5.1.4.1.1.66.4");
  set.push_back(shorts({0x0028, 0x0002}, {1}));
  set.push_back(text({0x0028, 0x0004}, "CS", "MONOCHROME2"));
  set.push_back(text({0x0028, 0x0008}, "IS", QByteArray::number(qsizetype(written.frames.size()))));
  set.push_back(shorts({0x0028, 0x0010}, {std::uint16_t(written.rows)}));
  set.push_back(shorts({0x0028, 0x0011}, {std::uint16_t(written.columns)}));
  set.push_back(shorts({0x0028, 0x0100}, {std::uint16_t(written.bits)}));
  set.push_back(shorts({0x0028, 0x0101}, {std::uint16_t(written.bits)}));
  set.push_back(shorts({0x0028, 0x0102}, {std::uint16_t(written.bits - 1)}));
  set.push_back(shorts({0x0028, 0x0103}, {0}));
  if (written.padding)
    set.push_back(shorts({0x0028, 0x0120}, {*written.padding}));
  set.push_back(text({0x0062, 0x0001}, "CS", typeOf(written)));
  std::vector<WrittenSet> segments;
  for (const WrittenSegment& segment : written.segments) {
    WrittenSet item;
    if (!segment.category.isEmpty())
      item.push_back(sequence({0x0062, 0x0003}, {code(segment.category)}));
    item.push_back(shorts({0x0062, 0x0004}, {segment.number}));
    item.push_back(text({0x0062, 0x0005}, "LO", segment.label));
    if (!segment.lab.empty())
      item.push_back(shorts({0x0062, 0x000d}, segment.lab));
    item.push_back(sequence({0x0062, 0x000f}, {code("Named by type")}));
    segments.push_back(std::move(item));
  }
  set.push_back(sequence({0x0062, 0x0002}, std::move(segments)));
  if (written.fractional)
    set.push_back(shorts({0x0062, 0x000e}, {255}));
  set.push_back(text({0x0070, 0x0084}, "PN", id[22]));
  const auto orientation =
      sequence({0x0020, 0x9116}, {{text({0x0020, 0x0037}, "DS", written.orientation)}});
  const auto number = [](double value) { return QByteArray::number(value, 'f', 4); };
  WrittenSet shared{
      sequence({0x0028, 0x9110},
               {{text({0x0018, 0x0088}, "DS", number(written.sliceSpacing)),
                 text({0x0028, 0x0030}, "DS",
                      number(written.rowSpacing) + "\\" + number(written.columnSpacing))}})};
  if (written.sharedOrientation)
    shared.insert(shared.begin(), orientation);
  set.push_back(sequence({0x5200, 0x9229}, {shared}));
  std::vector<WrittenSet> frames;
  for (const WrittenFrame& frame : written.frames) {
    WrittenSet item{
        sequence({0x0008, 0x9124}, {{text({0x0008, 0x1155}, "UI", id[21])}}),
        sequence({0x0020, 0x9113}, {{text({0x0020, 0x0032}, "DS", decimals(frame.position))}})};
    if (!written.sharedOrientation)
      item.push_back(orientation);
    if (!written.labelMap)
      item.push_back(sequence({0x0062, 0x000a}, {{shorts({0x0062, 0x000b}, {frame.segment})}}));
    frames.push_back(std::move(item));
  }
  set.push_back(sequence({0x5200, 0x9230}, std::move(frames)));
  set.push_back(pixelsOf(written));
  return set;
}

}  // namespace sline::test
