// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_dicom.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sline::test {

using model::Tag;

namespace {

constexpr std::uint32_t openLength = 0xffffffffu;

void put16(QByteArray& to, unsigned value) {
  to += char(value & 0xffu);
  to += char((value >> 8) & 0xffu);
}
void put32(QByteArray& to, std::uint32_t value) {
  put16(to, value & 0xffffu);
  put16(to, value >> 16);
}
void putTag(QByteArray& to, Tag tag) {
  put16(to, tag.group);
  put16(to, tag.element);
}

/// Says how elements are written.
struct Coding {
  bool explicitVr = true;
  bool openLengths = false;
  bool bigEndian = false;
};

/// Returns the bytes with every group of `size` reversed.
QByteArray turned(QByteArray bytes, qsizetype size) {
  for (qsizetype i = 0; i + size <= bytes.size(); i += size)
    std::reverse(bytes.begin() + i, bytes.begin() + i + size);
  return bytes;
}

/// Writes the head of an element or item, which has numbers of two and four bytes.
class Head {
 public:
  Head(Tag tag, const Coding& coding) : m_big(coding.bigEndian) {
    number(tag.group, 2);
    number(tag.element, 2);
  }
  Head& number(std::uint32_t value, qsizetype size) {
    QByteArray bytes;
    put32(bytes, value);
    bytes.truncate(size);
    m_bytes += m_big ? turned(bytes, size) : bytes;
    return *this;
  }
  Head& letters(const QByteArray& text) {
    m_bytes += text;
    return *this;
  }
  const QByteArray& bytes() const { return m_bytes; }

 private:
  QByteArray m_bytes;
  bool m_big;
};

bool isLong(const QByteArray& vr) {
  return vr == "OB" || vr == "OW" || vr == "SQ" || vr == "UN" || vr == "UT";
}

QByteArray encoded(const WrittenSet& set, const Coding& coding);

QByteArray encodedItems(const std::vector<WrittenSet>& items, const Coding& coding) {
  QByteArray bytes;
  for (const WrittenSet& item : items) {
    const QByteArray content = encoded(item, coding);
    const auto length = coding.openLengths ? openLength : std::uint32_t(content.size());
    bytes += Head({0xfffe, 0xe000}, coding).number(length, 4).bytes() + content;
    if (coding.openLengths)
      bytes += Head({0xfffe, 0xe00d}, coding).number(0, 4).bytes();
  }
  return bytes;
}

QByteArray encoded(const WrittenSet& set, const Coding& coding) {
  QByteArray bytes;
  for (const WrittenElement& element : set) {
    const bool isSequence = element.vr == "SQ";
    // Pieces of coded pixel data come with their items already written.
    const bool pieces = element.vr == "OB" && element.value.startsWith("\xfe\xff\x00\xe0");
    const bool open = (isSequence && coding.openLengths) || pieces;
    QByteArray value = isSequence ? encodedItems(element.items, coding) : element.value;
    if (value.size() % 2 != 0)
      value += element.vr == "UI" || element.vr == "OB" ? '\0' : ' ';
    if (coding.bigEndian && (element.vr == "US" || element.vr == "OW"))
      value = turned(value, 2);
    const auto length = open ? openLength : std::uint32_t(value.size());
    Head head(element.tag, coding);
    if (!coding.explicitVr)
      head.number(length, 4);
    else if (isLong(element.vr))
      head.letters(element.vr).number(0, 2).number(length, 4);
    else
      head.letters(element.vr).number(length, 2);
    bytes += head.bytes() + value;
    if (open)
      bytes += Head({0xfffe, 0xe0dd}, coding).number(0, 4).bytes();
  }
  return bytes;
}

const char* uidOf(Syntax syntax) {
  switch (syntax) {
    case Syntax::implicitLittle:
      return "1.2.840.10008.1.2";
    case Syntax::explicitLittle:
      return "1.2.840.10008.1.2.1";
    case Syntax::deflated:
      return "1.2.840.10008.1.2.1.99";
    case Syntax::runLength:
      return "1.2.840.10008.1.2.5";
    case Syntax::explicitBig:
      return "1.2.840.10008.1.2.2";
    case Syntax::jpeg2000:
      return "1.2.840.10008.1.2.4.90";
    case Syntax::htj2k:
      return "1.2.840.10008.1.2.4.201";
    case Syntax::mpeg:
      return "1.2.840.10008.1.2.4.100";
  }
  return "";
}

QByteArray deflated(const QByteArray& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  QByteArray packed(qsizetype(deflateBound(&stream, uLong(bytes.size()))), '\0');
  QByteArray input = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = uInt(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = uInt(packed.size());
  deflate(&stream, Z_FINISH);
  packed.truncate(qsizetype(stream.total_out));
  deflateEnd(&stream);
  return packed;
}

QByteArray decimals(const glm::dvec3& p) {
  return QByteArray::number(p.x, 'f', 3) + "\\" + QByteArray::number(p.y, 'f', 3) + "\\" +
         QByteArray::number(p.z, 'f', 3);
}

WrittenSet region(const WrittenRegion& written, int number) {
  WrittenSet item;
  if (written.colour)
    item.push_back(text({0x3006, 0x002a}, "IS",
                        QByteArray::number(written.colour->red) + "\\" +
                            QByteArray::number(written.colour->green) + "\\" +
                            QByteArray::number(written.colour->blue)));
  std::vector<WrittenSet> contours;
  for (const auto& contour : written.contours) {
    QByteArray data;
    for (const glm::dvec3& p : contour)
      data += (data.isEmpty() ? "" : "\\") + decimals(p);
    contours.push_back({text({0x3006, 0x0042}, "CS", written.geometry),
                        text({0x3006, 0x0046}, "IS", QByteArray::number(qsizetype(contour.size()))),
                        // A DS with more than 64 kB does not fit two bytes of length.
                        text({0x3006, 0x0050}, data.size() > 0xfffe ? "UT" : "DS", data)});
  }
  if (!contours.empty())
    item.push_back(sequence({0x3006, 0x0040}, std::move(contours)));
  item.push_back(text({0x3006, 0x0084}, "IS", QByteArray::number(number)));
  return item;
}

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

WrittenElement text(Tag tag, const char* vr, const QByteArray& value) {
  return {tag, vr, value, {}};
}

WrittenElement shorts(Tag tag, const std::vector<std::uint16_t>& values) {
  QByteArray bytes;
  for (const std::uint16_t value : values)
    put16(bytes, value);
  return {tag, "US", bytes, {}};
}

QByteArray runs(const std::vector<QByteArray>& planes) {
  QByteArray head;
  QByteArray packed;
  put32(head, std::uint32_t(planes.size()));
  for (const QByteArray& bytes : planes) {
    put32(head, std::uint32_t(64 + packed.size()));
    for (qsizetype at = 0; at < bytes.size();) {
      qsizetype same = 1;
      while (at + same < bytes.size() && same < 128 && bytes[at + same] == bytes[at])
        ++same;
      packed += same > 1 ? char(257 - same) : char(0);
      packed += bytes[at];
      at += same;
    }
    if (packed.size() % 2 != 0)
      packed += '\0';
  }
  head.resize(64, '\0');
  return head + packed;
}

WrittenElement pieces(const std::vector<QByteArray>& frames) {
  QByteArray items;
  putTag(items, {0xfffe, 0xe000});
  put32(items, 0);
  for (const QByteArray& frame : frames) {
    putTag(items, {0xfffe, 0xe000});
    put32(items, std::uint32_t(frame.size() + frame.size() % 2));
    items += frame;
    if (frame.size() % 2 != 0)
      items += '\0';
  }
  return {{0x7fe0, 0x0010}, "OB", items, {}};
}

WrittenElement cutPieces(const std::vector<QByteArray>& frames, qsizetype size) {
  QByteArray table;
  QByteArray items;
  const auto put = [](QByteArray& to, const QByteArray& bytes) {
    putTag(to, {0xfffe, 0xe000});
    put32(to, std::uint32_t(bytes.size() + bytes.size() % 2));
    to += bytes + QByteArray(bytes.size() % 2, '\0');
  };
  for (const QByteArray& frame : frames) {
    put32(table, std::uint32_t(items.size()));
    for (qsizetype at = 0; at < frame.size(); at += size)
      put(items, frame.mid(at, size));
  }
  QByteArray all;
  put(all, table);
  return {{0x7fe0, 0x0010}, "OB", all + items, {}};
}

WrittenElement sequence(Tag tag, std::vector<WrittenSet> items) {
  return {tag, "SQ", {}, std::move(items)};
}

QByteArray dicomFile(const WrittenSet& set, const Manner& manner) {
  const QByteArray body = encoded(set, {manner.syntax != Syntax::implicitLittle, manner.openLengths,
                                        manner.syntax == Syntax::explicitBig});
  if (!manner.preamble)
    return body;
  const WrittenSet meta{text({0x0002, 0x0002}, "UI", set.front().value),
                        text({0x0002, 0x0010}, "UI", uidOf(manner.syntax))};
  const QByteArray rest = encoded(meta, {});
  QByteArray file(128, '\0');
  file += "DICM";
  putTag(file, {0x0002, 0x0000});
  file += "UL";
  put16(file, 4);
  put32(file, std::uint32_t(rest.size()));
  return file + rest + (manner.syntax == Syntax::deflated ? deflated(body) : body);
}

WrittenSet nested(int depth) {
  WrittenSet set{text({0x0008, 0x0104}, "LO", "deep")};
  for (int i = 0; i < depth; ++i)
    set = {sequence({0x0040, 0xa730}, {set})};
  return set;
}

const std::vector<QByteArray>& identities() {
  static const std::vector<QByteArray> all{
      "QZX.9.87.SOP",    "19991231",       "235959",         "QZX-ACCESSION",  "QZX-INSTITUTION",
      "QZX-PHYSICIAN",   "QZX-STATION",    "QZX-STUDYTEXT",  "QZX-SERIESTEXT", "QZX-OPERATOR",
      "QZXNAME^QZXJANE", "QZX-PATIENTID",  "19700229",       "QZX-ADDRESS",    "QZX.9.87.STUDY",
      "QZX.9.87.SERIES", "QZX-STUDYID",    "QZX.9.87.FRAME", "QZX-SETLABEL",   "QZX-ROITEXT",
      "QZX-OBSERVER",    "QZX.9.87.IMAGE", "QZX-CREATOR"};
  return all;
}

WrittenSet identifying(const char* sopClass) {
  const auto& id = identities();
  return {text({0x0008, 0x0016}, "UI", sopClass), text({0x0008, 0x0018}, "UI", id[0]),
          text({0x0008, 0x0020}, "DA", id[1]),    text({0x0008, 0x0030}, "TM", id[2]),
          text({0x0008, 0x0050}, "SH", id[3]),    text({0x0008, 0x0080}, "LO", id[4]),
          text({0x0008, 0x0090}, "PN", id[5]),    text({0x0008, 0x1010}, "SH", id[6]),
          text({0x0008, 0x1030}, "LO", id[7]),    text({0x0008, 0x103e}, "LO", id[8]),
          text({0x0008, 0x1070}, "PN", id[9]),    text({0x0010, 0x0010}, "PN", id[10]),
          text({0x0010, 0x0020}, "LO", id[11]),   text({0x0010, 0x0030}, "DA", id[12]),
          text({0x0010, 0x1040}, "LO", id[13]),   text({0x0020, 0x000d}, "UI", id[14]),
          text({0x0020, 0x000e}, "UI", id[15]),   text({0x0020, 0x0010}, "SH", id[16]),
          text({0x0020, 0x0052}, "UI", id[17])};
}

WrittenSet structureSet(const std::vector<WrittenRegion>& regions) {
  const auto& id = identities();
  WrittenSet set = identifying("1.2.840.10008.5.1.4.1.1.481.3");
  set.push_back(text({0x3006, 0x0002}, "SH", id[18]));
  std::vector<WrittenSet> names;
  std::vector<WrittenSet> contours;
  std::vector<WrittenSet> observed;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const QByteArray number = QByteArray::number(qsizetype(i) + 1);
    names.push_back({text({0x3006, 0x0022}, "IS", number), text({0x3006, 0x0024}, "UI", id[17]),
                     text({0x3006, 0x0026}, "LO", regions[i].name),
                     text({0x3006, 0x0028}, "ST", id[19])});
    contours.push_back(region(regions[i], int(i) + 1));
    observed.push_back({text({0x3006, 0x0084}, "IS", number),
                        text({0x3006, 0x00a4}, "CS", regions[i].type),
                        text({0x3006, 0x00a6}, "PN", id[20])});
  }
  set.push_back(sequence({0x3006, 0x0020}, std::move(names)));
  set.push_back(sequence({0x3006, 0x0039}, std::move(contours)));
  set.push_back(sequence({0x3006, 0x0080}, std::move(observed)));
  return set;
}

std::vector<glm::dvec3> circle(const glm::dvec3& centre, double radius, int corners) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    points.push_back(centre + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return points;
}

std::vector<std::vector<glm::dvec3>> ball(const glm::dvec3& centre, double radius, double first,
                                          double step) {
  std::vector<std::vector<glm::dvec3>> contours;
  for (double z = first; z < centre.z + radius; z += step)
    if (std::abs(z - centre.z) < radius)
      contours.push_back(circle({centre.x, centre.y, z},
                                std::sqrt(radius * radius - (z - centre.z) * (z - centre.z))));
  return contours;
}

std::vector<std::vector<glm::dvec3>> rod(const glm::dvec3& centre, double radius,
                                         const std::vector<double>& heights) {
  std::vector<std::vector<glm::dvec3>> contours;
  for (const double height : heights)
    contours.push_back(circle({centre.x, centre.y, height}, radius));
  return contours;
}

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
