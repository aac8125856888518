// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace sline::model {

namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view magic = "DICM";
constexpr std::string_view implicitLittle = "1.2.840.10008.1.2";
constexpr std::string_view explicitLittle = "1.2.840.10008.1.2.1";
constexpr std::string_view deflated = "1.2.840.10008.1.2.1.99";
constexpr std::string_view explicitBig = "1.2.840.10008.1.2.2";
constexpr std::string_view runLength = "1.2.840.10008.1.2.5";

struct ObjectClass {
  std::string_view uid;  ///< or its beginning, for a family of kinds
  std::string_view name;
  bool image;
};
/// The longest beginning that fits names the kind.
constexpr std::array classes = {
    ObjectClass{"1.2.840.10008.5.1.4.1.1.1", "X-ray image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.2", "CT image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.3", "ultrasound image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.4", "MR image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.6", "ultrasound image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.7", "secondary capture image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.9", "waveform", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.11", "presentation state", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.12", "X-ray angiography image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.13", "X-ray 3D image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.14", "intravascular image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.20", "nuclear medicine image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.30", "parametric map", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66", "raw data", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.1", "spatial registration", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.2", "spatial fiducials", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.3", "deformable registration", false},
    ObjectClass{segmentationClass, "segmentation", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.5", "surface segmentation", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.6", "tractography", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.67", "real world value mapping", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.77", "visible light image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.88", "structured report", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.104", "encapsulated document", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.128", "PET image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.130", "PET image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.1", "RT image", true},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.2", "RT dose", false},
    ObjectClass{structureSetClass, "RT structure set", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.4", "RT beams treatment record", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.5", "RT plan", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.6", "RT brachy treatment record", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.7", "RT treatment summary", false},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.8", "RT ion plan", false},
    ObjectClass{"1.2.840.10008.1.3.10", "media directory (DICOMDIR)", false}};

const ObjectClass* classOf(std::string_view uid) {
  const ObjectClass* best = nullptr;
  for (const ObjectClass& row : classes) {
    const bool fits = uid == row.uid || (uid.starts_with(row.uid) && uid[row.uid.size()] == '.');
    if (fits && (!best || row.uid.size() > best->uid.size()))
      best = &row;
  }
  return best;
}

/// Without a preamble a file begins with its first element, of group 2 (a meta header) or 8.
bool beginsWithElement(std::string_view text) {
  return text.size() >= 16 && (text[0] == 2 || text[0] == 8) && text[1] == 0 && text[3] == 0 &&
         ((isUpper(text[4]) && isUpper(text[5])) || (text[6] == 0 && text[7] == 0));
}

bool hasExplicitVr(std::string_view text) {
  return text.size() >= 6 && isUpper(text[4]) && isUpper(text[5]);
}

/// The elements of group 2 at the beginning: always explicit little endian (PS3.10 §7.1).
std::size_t metaSize(std::string_view text) {
  // Its first element, of twelve bytes, says how long the rest is.
  if (text.size() < 12 || text[0] != 2 || text[1] != 0)
    return 0;
  if (text[2] == 0 && text[3] == 0) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
      length |= std::size_t(static_cast<unsigned char>(text[8 + i])) << (8 * i);
    return std::min(text.size(), 12 + length);
  }
  std::size_t at = 0;
  while (at + 12 <= text.size() && text[at] == 2 && text[at + 1] == 0) {
    const auto byte = [&](std::size_t i) {
      return std::size_t(static_cast<unsigned char>(text[at + i]));
    };
    const std::string_view vr = text.substr(at + 4, 2);
    const bool wide = vr == "OB" || vr == "UN" || vr == "UT";
    const std::size_t length =
        wide ? byte(8) | byte(9) << 8 | byte(10) << 16 | byte(11) << 24 : byte(6) | byte(7) << 8;
    at += (wide ? 12 : 8) + length;
  }
  return std::min(at, text.size());
}

constexpr std::size_t beginningRead = 4096;

std::string beginningOf(const std::filesystem::path& file, std::size_t size) {
  std::string text(size, '\0');
  std::FILE* handle = std::fopen(file.string().c_str(), "rb");
  text.resize(handle ? std::fread(text.data(), 1, size, handle) : 0);
  if (handle)
    std::fclose(handle);
  return text;
}

void appendUtf8(std::string& to, unsigned code) {
  to += char(0xc0 | code >> 6);
  to += char(0x80 | (code & 0x3f));
}

/// How many bytes the UTF-8 character at `at` has; 0 where there is none.
std::size_t characterAt(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t size = first >= 0xf5   ? 0
                           : first >= 0xf0 ? 4
                           : first >= 0xe0 ? 3
                           : first >= 0xc2 ? 2
                                           : 0;
  if (at + size > text.size())
    return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80)
      return 0;
  return size;
}

}  // namespace

std::string_view objectName(std::string_view sopClass) {
  const ObjectClass* known = classOf(sopClass);
  return known ? known->name : std::string_view();
}

bool isImageClass(std::string_view sopClass) {
  const ObjectClass* known = classOf(sopClass);
  return known && known->image;
}

Status DicomFile::unpack(std::string_view packed) {
  // What masks deflate to is small, but no file may ask for a large machine.
  const std::size_t limit = (std::size_t(128) << 20) + 32 * packed.size();
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
    return m_source->whole("cannot be unpacked: out of memory", "Close other programs");
  m_unpacked = std::make_unique<std::string>();
  std::vector<char> block(std::size_t(1) << 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  int state = Z_OK;
  std::size_t rest = packed.size();
  while (state == Z_OK && m_unpacked->size() <= limit) {
    const auto portion = uInt(std::min<std::size_t>(rest, std::size_t(1) << 30));
    stream.avail_in = portion;
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = uInt(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    rest -= portion - stream.avail_in;
    m_unpacked->append(block.data(), block.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (m_unpacked->size() > limit)
    return m_source->whole("its deflated data grows beyond " + std::to_string(limit) + " bytes",
                           "Export it without compression");
  if (state != Z_STREAM_END)
    return m_source->at("byte " + std::to_string(m_source->size() - rest),
                        "the deflated data ends early or is damaged", "Copy the file again");
  return Unit{};
}

Result<DicomFile> DicomFile::read(const std::filesystem::path& file, const ReadLimits& limits) {
  Result<Source> source = Source::read(file, limits);
  if (!source)
    return source.error();
  DicomFile dicom;
  dicom.m_source = std::make_unique<Source>(std::move(*source));
  const std::string_view text = dicom.m_source->text();
  const bool withPreamble =
      text.size() >= preamble + magic.size() && text.substr(preamble, magic.size()) == magic;
  std::string_view rest = withPreamble ? text.substr(preamble + magic.size()) : text;
  if (!withPreamble && !beginsWithElement(text))
    return dicom.m_source->whole(
        "is not a DICOM file: neither 'DICM' nor an element stands where "
        "it should",
        "Give the file the extension of its kind");
  dicom.m_bytes = std::make_unique<DicomBytes>(DicomBytes{dicom.m_source.get(), text, false});
  const std::size_t metaBytes = metaSize(rest);
  const Result<DataSet> meta = DataSet::parse(*dicom.m_bytes, rest.substr(0, metaBytes), true);
  if (!meta)
    return meta.error();
  rest.remove_prefix(metaBytes);
  const std::string_view syntax = meta->text({0x0002, 0x0010});
  if (syntax == explicitBig)
    return dicom.m_source->whole("is written in the retired big endian transfer syntax",
                                 "Export it as explicit or implicit VR little endian");
  if (syntax == deflated) {
    if (const Status status = dicom.unpack(rest); !status)
      return status.error();
    rest = *dicom.m_unpacked;
    *dicom.m_bytes = {dicom.m_source.get(), rest, true};
  }
  const bool explicitVr = syntax.empty() ? hasExplicitVr(rest) : syntax != implicitLittle;
  Result<DataSet> data = DataSet::parse(*dicom.m_bytes, rest, explicitVr);
  if (!data)
    return data.error();
  dicom.m_data = std::move(*data);
  dicom.m_sopClass = dicom.m_data.text({0x0008, 0x0016});
  if (dicom.m_sopClass.empty())
    dicom.m_sopClass = meta->text({0x0002, 0x0002});
  const bool native =
      syntax.empty() || syntax == implicitLittle || syntax == explicitLittle || syntax == deflated;
  dicom.m_pixelCoding = native                ? PixelCoding::native
                        : syntax == runLength ? PixelCoding::runLength
                                              : PixelCoding::other;
  return dicom;
}

std::string DicomFile::utf8(std::string_view text) const {
  const std::string_view set = m_data.text({0x0008, 0x0005});
  const bool unicode = set.ends_with("ISO_IR 192");
  const bool latin = set.ends_with("ISO_IR 100") || set.ends_with("ISO 2022 IR 100");
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t size = unicode && c >= 0x80 ? characterAt(text, i) : 0;
    if (size > 0) {
      result += text.substr(i, size);
      i += size;
      continue;
    }
    if (c >= 0xa0 && latin)
      appendUtf8(result, c);
    else
      result += c >= 0x80 ? '?' : c < 0x20 ? ' ' : char(c);
    ++i;
  }
  return result;
}

bool mayBeDicom(const std::filesystem::path& file) {
  // "IM0001", "1.2.840.113619.2.55", "slice.ima"
  const std::string extension = file.extension().string();
  const bool digits = std::all_of(extension.begin(), extension.end(),
                                  [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
  if (!digits && extension != ".ima" && extension != ".IMA")
    return false;
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault))
    return false;
  const std::string text = beginningOf(file, preamble + magic.size());
  return text.size() == preamble + magic.size() &&
         (text.ends_with(magic) || beginsWithElement(text));
}

std::string sopClassOf(const std::filesystem::path& file) {
  const std::string text = beginningOf(file, beginningRead);
  std::string_view rest = text;
  if (rest.size() > preamble + magic.size() && rest.substr(preamble, magic.size()) == magic)
    rest.remove_prefix(preamble + magic.size());
  else if (!beginsWithElement(rest))
    return {};
  const std::size_t meta = metaSize(rest);
  const std::string_view byMeta = firstTextIn(rest.substr(0, meta), {0x0002, 0x0002}, true);
  if (!byMeta.empty())
    return std::string(byMeta);
  rest.remove_prefix(meta);
  return std::string(firstTextIn(rest, {0x0008, 0x0016}, hasExplicitVr(rest)));
}

}  // namespace sline::model
