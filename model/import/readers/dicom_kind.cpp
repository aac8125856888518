// SPDX-License-Identifier: Apache-2.0
#include "model/import/readers/dicom_kind.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

namespace sline::model {

namespace {

constexpr std::size_t preamble = 128;
constexpr std::string_view magic = "DICM";
constexpr std::size_t beginningRead = 4096;

struct DicomTag {
  unsigned group = 0;
  unsigned element = 0;
  bool operator==(const DicomTag&) const = default;
};

struct ObjectClass {
  std::string_view uid;  ///< or the beginning of one, for a family of kinds
  std::string_view name;
  std::string_view scanner = {};  ///< for slices that make a volume
};
/// The longest matching beginning names the kind.
constexpr std::array classes = {
    ObjectClass{"1.2.840.10008.5.1.4.1.1.1", "X-ray image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.2", "CT image", "CT"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.3", "ultrasound image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.4", "MR image", "MR"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.6", "ultrasound image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.7", "secondary capture image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.9", "waveform"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.11", "presentation state"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.12", "X-ray angiography image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.13", "X-ray 3D image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.14", "intravascular image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.20", "nuclear medicine image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.30", "parametric map"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66", "raw data"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.1", "spatial registration"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.2", "spatial fiducials"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.3", "deformable registration"},
    ObjectClass{segmentationClass, "segmentation"},
    ObjectClass{labelMapClass, "label map segmentation"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.5", "surface segmentation"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.66.6", "tractography"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.67", "real world value mapping"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.77", "visible light image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.88", "structured report"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.104", "encapsulated document"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.128", "PET image", "PET"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.130", "PET image", "PET"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.1", "RT image"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.2", "RT dose"},
    ObjectClass{structureSetClass, "RT structure set"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.4", "RT beams treatment record"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.5", "RT plan"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.6", "RT brachy treatment record"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.7", "RT treatment summary"},
    ObjectClass{"1.2.840.10008.5.1.4.1.1.481.8", "RT ion plan"},
    ObjectClass{"1.2.840.10008.1.3.10", "media directory (DICOMDIR)"}};

const ObjectClass* classOf(std::string_view uid) {
  const ObjectClass* best = nullptr;
  for (const ObjectClass& row : classes) {
    const bool fits = uid == row.uid || (uid.starts_with(row.uid) && uid[row.uid.size()] == '.');
    if (fits && (!best || row.uid.size() > best->uid.size()))
      best = &row;
  }
  return best;
}

bool isCapital(char c) {
  return c >= 'A' && c <= 'Z';
}

std::uint32_t littleEndian(std::string_view text, std::size_t at, std::size_t bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i)
    value |= std::uint32_t(static_cast<unsigned char>(text[at + i])) << (8 * i);
  return value;
}

/// Describes one element's head in little endian, with explicit or implicit VR as its own bytes
/// tell.
struct ElementHead {
  DicomTag tag;
  std::size_t size = 8;
  std::uint32_t length = 0;
};
std::optional<ElementHead> headOf(std::string_view text) {
  if (text.size() < 12)
    return std::nullopt;
  ElementHead head{{littleEndian(text, 0, 2), littleEndian(text, 2, 2)}};
  const std::string_view vr = text.substr(4, 2);
  if (!isCapital(vr[0]) || !isCapital(vr[1])) {
    head.length = littleEndian(text, 4, 4);
  } else if (vr == "OB" || vr == "OW" || vr == "SQ" || vr == "UN" || vr == "UT") {
    head.size = 12;
    head.length = littleEndian(text, 8, 4);
  } else {
    head.length = littleEndian(text, 6, 2);
  }
  return head;
}

/// Returns the text without the blanks and zeros that pad it.
std::string_view unpadded(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view(" \0", 2));
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

/// Tells whether the file begins with an element: without a preamble its first element is of group
/// 2 (a meta header) or 8.
bool beginsWithElement(std::string_view text) {
  return text.size() >= 16 && (text[0] == 2 || text[0] == 8) && text[1] == 0 && text[3] == 0 &&
         ((isCapital(text[4]) && isCapital(text[5])) || (text[6] == 0 && text[7] == 0));
}

bool hasMagic(std::string_view text) {
  return text.size() >= preamble + magic.size() && text.substr(preamble, magic.size()) == magic;
}

std::string beginningOf(const std::filesystem::path& file, std::size_t size) {
  std::string text(size, '\0');
  std::FILE* handle = std::fopen(file.string().c_str(), "rb");
  text.resize(handle ? std::fread(text.data(), 1, size, handle) : 0);
  if (handle)
    std::fclose(handle);
  return text;
}

}  // namespace

std::string_view objectName(std::string_view sopClass) {
  const ObjectClass* known = classOf(sopClass);
  return known ? known->name : std::string_view();
}

bool holdsStructures(std::string_view sopClass) {
  return sopClass == structureSetClass || sopClass == segmentationClass ||
         sopClass == labelMapClass;
}

std::string_view scannerOf(std::string_view sopClass) {
  const ObjectClass* known = classOf(sopClass);
  return known ? known->scanner : std::string_view();
}

bool beginsLikeDicom(std::string_view text) {
  return hasMagic(text) || beginsWithElement(text);
}

bool mayBeDicom(const std::filesystem::path& file) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault))
    return false;
  const std::string text = beginningOf(file, preamble + magic.size());
  if (text.size() != preamble + magic.size())
    return false;
  // Without the magic word the name must speak for it: "IM0001", "1.2.840.113619.2.55",
  // "slice.ima".
  const std::string extension = file.extension().string();
  const bool digits = std::all_of(extension.begin(), extension.end(),
                                  [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
  const bool called = digits || extension == ".ima" || extension == ".IMA";
  return called ? beginsLikeDicom(text) : hasMagic(text);
}

std::string sopClassOf(const std::filesystem::path& file) {
  constexpr DicomTag byMeta{0x0002, 0x0002};
  constexpr DicomTag byData{0x0008, 0x0016};
  const std::string text = beginningOf(file, beginningRead);
  if (!beginsLikeDicom(text))
    return {};
  std::string_view rest = text;
  if (hasMagic(rest))
    rest.remove_prefix(preamble + magic.size());
  while (const std::optional<ElementHead> head = headOf(rest)) {
    if (head->length > rest.size() - head->size)
      break;
    if (head->tag == byMeta || head->tag == byData)
      return std::string(unpadded(rest.substr(head->size, head->length)));
    rest.remove_prefix(head->size + head->length);
  }
  return {};
}

}  // namespace sline::model
