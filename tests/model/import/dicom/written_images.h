// SPDX-License-Identifier: Apache-2.0
// Writes slices of scanners for the tests, with pixel data packed by DCMTK's and OpenJPEG's
// encoders.
#pragma once

#include <QTemporaryDir>
#include <filesystem>
#include <functional>

#include "tests/model/import/dicom/written_dicom.h"

namespace sline::test {

inline constexpr const char* ctClass = "1.2.840.10008.5.1.4.1.1.2";
inline constexpr const char* mrClass = "1.2.840.10008.5.1.4.1.1.4";
inline constexpr const char* petClass = "1.2.840.10008.5.1.4.1.1.128";
inline constexpr const char* enhancedMrClass = "1.2.840.10008.5.1.4.1.1.4.1";

/// Holds a slice of 16-bit pixels.
struct WrittenImage {
  const char* sopClass = ctClass;
  QByteArray series = "QZX.9.87.SERIES";
  int columns = 16;
  int rows = 12;
  glm::dvec3 position{0.0};
  QByteArray orientation = "1\\0\\0\\0\\1\\0";
  QByteArray spacing = "0.8\\0.5";  ///< between rows, then between columns
  std::uint16_t stored = 16;        ///< bits
  bool isSigned = true;
  double slope = 1.0;
  double intercept = -1024.0;
  std::function<int(int x, int y)> value = [](int x, int y) { return 100 * y + x; };
};
std::vector<std::uint16_t> pixelsOf(const WrittenImage& written);
WrittenSet image(const WrittenImage& written);
/// Returns one enhanced image of these slices, in their order.
WrittenSet enhancedImage(const std::vector<WrittenImage>& slices);

/// Says how the pixels of a file are packed.
enum class Packing { none, jpegBaseline, jpegExtended, jpegLossless, jpegLs, jpegLsNear };
/// Returns the file with its pixel data packed that way; aborts the test program if the encoder
/// refuses.
QByteArray packed(const QByteArray& file, Packing packing);

/// Returns a frame's pixels as a bare codestream, without loss.
QByteArray jpeg2000(const std::vector<std::uint16_t>& pixels, int columns, int rows, int bits,
                    bool isSigned);
/// Returns the slice with its pixels packed as JPEG 2000.
QByteArray jpeg2000File(const WrittenImage& written, Syntax syntax = Syntax::jpeg2000);
/// Returns a slice's pixels in two planes of runs.
QByteArray runsOf(const WrittenImage& written);
/// Returns the slice with its pixels in runs.
QByteArray runLengthFile(const WrittenImage& written);

/// Writes the file's bytes into the folder and returns the path.
std::filesystem::path put(const QTemporaryDir& folder, const QString& name,
                          const QByteArray& bytes);

}  // namespace sline::test
