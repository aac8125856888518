// SPDX-License-Identifier: Apache-2.0
// The frames of a segmentation's pixel data as masks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/import/dicom/dicom_file.h"

namespace sline::model {

/// Binary segmentations have one bit a pixel, the lowest of a byte first (PS3.5 §8.1.1), fractional
/// ones a byte, of which half the greatest value and more counts as inside. Native (deflated or
/// not) and run-length coded (PS3.5 annex G).
class SegmentPixels {
 public:
  /// Errors: other codings, other depths, sizes of 0, data that is shorter than its frames.
  static Result<SegmentPixels> open(const DicomFile& file);

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  std::size_t frames() const { return m_frames; }
  std::size_t frameSize() const { return std::size_t(m_columns) * std::size_t(m_rows); }
  /// 1 inside, 0 outside; x fastest.
  Status mask(std::size_t frame, std::vector<std::uint8_t>& inside) const;

 private:
  explicit SegmentPixels(const DicomFile& file) : m_file(&file) {}
  std::optional<Error> readSizes();
  std::optional<Error> readCoded(const DataElement& data);
  Result<std::string> unpacked(std::string_view fragment) const;

  const DicomFile* m_file;
  int m_columns = 0;
  int m_rows = 0;
  std::size_t m_frames = 0;
  bool m_bits = true;         ///< one bit a pixel rather than a byte
  std::uint8_t m_inside = 1;  ///< bytes from here on are inside
  std::string_view m_native;
  std::vector<std::string_view> m_coded;  ///< one fragment a frame
};

}  // namespace sline::model
