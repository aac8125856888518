// SPDX-License-Identifier: Apache-2.0
// A DICOM file as a whole (PS3.10): its preamble, transfer syntax and kind of object. Only what
// makes surfaces is ever asked of it: nothing here reads names, numbers, dates or UIDs of a
// patient.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/import/dicom/data_set.h"

namespace sline::model {

inline constexpr std::string_view structureSetClass = "1.2.840.10008.5.1.4.1.1.481.3";
inline constexpr std::string_view segmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";

/// The name of a kind of object (PS3.4 §B.5): "CT image", "RT plan"; empty for kinds not listed.
std::string_view objectName(std::string_view sopClass);
/// True for slices and volumes of grey values.
bool isImageClass(std::string_view sopClass);

/// How the pixel data of a file lies there.
enum class PixelCoding { native, runLength, other };

class DicomFile {
 public:
  /// Errors: not DICOM, cut short (with the byte), big endian, unpacked data beyond its limit.
  static Result<DicomFile> read(const std::filesystem::path& file, const ReadLimits& limits);

  const DataSet& data() const { return m_data; }
  const Source& source() const { return *m_source; }
  std::string_view sopClass() const { return m_sopClass; }
  PixelCoding pixelCoding() const { return m_pixelCoding; }
  /// A text value as UTF-8, by the file's character set; what cannot be told is '?'.
  std::string utf8(std::string_view text) const;

 private:
  DicomFile() = default;
  Status unpack(std::string_view packed);

  std::unique_ptr<Source> m_source;
  std::unique_ptr<std::string> m_unpacked;
  std::unique_ptr<DicomBytes> m_bytes;  ///< data sets point to it, so it stays where it is
  DataSet m_data;
  std::string_view m_sopClass;
  PixelCoding m_pixelCoding = PixelCoding::native;
};

/// True for a file without an extension, or with numbers for one, whose content says DICOM: "DICM"
/// behind the preamble, or no preamble and a first element of group 2 or 8.
bool mayBeDicom(const std::filesystem::path& file);
/// The kind of object from the first kilobytes of a file; empty where they do not tell.
std::string sopClassOf(const std::filesystem::path& file);

}  // namespace sline::model
