// SPDX-License-Identifier: Apache-2.0
// Unpacks the frames of a file's pixel data one at a time.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/import/dicom/dicom_file.h"

namespace sline::model {

/// Unpacks frames with one value per pixel, of 1 bit (the lowest of a byte first, PS3.5 §8.1.1), 8
/// or 16 bits. It reads native data in any byte order (deflated or not), run-length coded data
/// (PS3.5 annex G; DCMTK refuses such masks of bits), JPEG and JPEG-LS by DCMTK, JPEG 2000 (with
/// HTJ2K) by OpenJPEG.
class PixelFrames {
 public:
  /// Opens the pixel data. Errors: no pixel data, other codings and depths, colours, sizes of 0 or
  /// beyond those that scanners make, data that is shorter than its frames.
  static Result<PixelFrames> open(const DicomFile& file);

  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  std::size_t frames() const { return m_frames; }
  std::size_t frameSize() const { return std::size_t(m_columns) * std::size_t(m_rows); }
  int bits() const { return m_bits; }
  /// Returns the bits of each pixel as they stand in the file, x fastest: the caller has to know
  /// whether there is a sign and which of 16 bits are used.
  Status frame(std::size_t index, std::vector<std::uint16_t>& values) const;
  /// Tells whether two frames are packed into the same bytes, so that both have the same pixels.
  bool packedAlike(std::size_t a, std::size_t b) const {
    return !m_coded.empty() && m_coded[a] == m_coded[b];
  }

 private:
  explicit PixelFrames(const DicomFile& file) : m_file(&file) {}
  Status readSizes();
  Status openNative();
  Status openPacked();
  Status groupFragments(const std::vector<std::string_view>& fragments);
  Error damaged(std::size_t index, const std::string& why = {}) const;
  std::size_t frameBytes() const;
  void unpack(std::string_view bytes, std::size_t firstPixel,
              std::vector<std::uint16_t>& values) const;
  Status byRuns(std::size_t index, std::vector<std::uint16_t>& values) const;
  Status byLibrary(std::size_t index, std::vector<std::uint16_t>& values) const;

  const DicomFile* m_file;
  int m_columns = 0;
  int m_rows = 0;
  std::size_t m_frames = 0;
  int m_bits = 8;
  std::string_view m_native;                           ///< little endian
  std::vector<std::vector<std::string_view>> m_coded;  ///< the fragments of each frame
};

}  // namespace sline::model
