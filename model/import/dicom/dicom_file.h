// SPDX-License-Identifier: Apache-2.0
// Reads a DICOM file as a whole (PS3.10): its preamble, transfer syntax and kind of object. It is
// asked only for the data from which surfaces and volumes are made: nothing here reads names,
// numbers or dates of a patient.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/import/dicom/data_set.h"
#include "model/import/readers/dicom_kind.h"
#include "model/import/source/source.h"

class DcmDataset;

namespace sline::model {

/// Lists the ways in which a file's pixel data may be coded, by the decoder that unpacks them.
enum class PixelCoding { native, runLength, jpeg, jpeg2000, other };

class DicomFile {
 public:
  /// Reads the whole file. Errors: not DICOM, cut short or damaged (with the byte), nested too
  /// deep, unpacked data beyond its limit.
  static Result<DicomFile> read(const std::filesystem::path& file, const ReadLimits& limits);
  /// Reads the file without the elements that follow its patient, scanner and series, which takes a
  /// few kilobytes of most files.
  static Result<DicomFile> readBeginning(const std::filesystem::path& file,
                                         const ReadLimits& limits);

  const DataSet& data() const { return m_data; }
  /// Gives the decoders of pixel data access to the data set, from which they take the elements
  /// they need.
  DcmDataset& dataset() const { return *m_dataset; }
  const Source& source() const { return m_source; }
  const std::string& sopClass() const { return m_sopClass; }
  PixelCoding pixelCoding() const { return m_pixelCoding; }

 private:
  enum class Extent { whole, beginning };
  explicit DicomFile(Source source) : m_source(std::move(source)) {}
  static Result<DicomFile> parsed(Source source, Extent extent);
  Result<std::string> unpacked(std::string_view packed) const;
  Status parseData(std::string_view text, const std::string& syntax, Extent extent);

  Source m_source;
  std::unique_ptr<const std::string> m_inflated;  ///< the inflated data of a deflated file
  std::shared_ptr<DcmDataset> m_dataset;          ///< takes long values from the two above
  DataSet m_data;
  std::string m_sopClass;
  PixelCoding m_pixelCoding = PixelCoding::native;
};

}  // namespace sline::model
