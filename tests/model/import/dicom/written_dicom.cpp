// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_dicom.h"

#include <zlib.h>

#include <algorithm>

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

QByteArray decimals(const glm::dvec3& p) {
  return QByteArray::number(p.x, 'f', 3) + "\\" + QByteArray::number(p.y, 'f', 3) + "\\" +
         QByteArray::number(p.z, 'f', 3);
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

}  // namespace sline::test
