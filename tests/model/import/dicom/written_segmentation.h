// SPDX-License-Identifier: Apache-2.0
// Writes segmentations for the tests.
#pragma once

#include <QByteArray>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "tests/model/import/dicom/written_dicom.h"

namespace sline::test {

struct WrittenSegment {
  std::uint16_t number = 1;
  QByteArray label;
  QByteArray category;
  std::vector<std::uint16_t> lab;
};
/// Holds the pixels of one frame, 0 … 255, in rows, and the position of its first pixel.
struct WrittenFrame {
  std::uint16_t segment = 1;
  glm::dvec3 position{0.0};
  std::vector<std::uint8_t> pixels;
};
struct WrittenSegmentation {
  int columns = 8;
  int rows = 8;
  double columnSpacing = 1.0;
  double rowSpacing = 1.0;
  double sliceSpacing = 2.0;
  QByteArray orientation = "1\\0\\0\\0\\1\\0";
  int bits = 1;  ///< bits of a pixel: 1, 8 or 16
  bool fractional = false;
  bool labelMap = false;                 ///< a pixel is the number of its segment
  std::optional<std::uint16_t> padding;  ///< a label map's background
  bool sharedOrientation = true;
  bool runLength = false;
  std::function<QByteArray(const WrittenFrame&)> pack;  ///< packs a frame's pixels
  std::vector<WrittenSegment> segments;
  std::vector<WrittenFrame> frames;
};
WrittenSet segmentation(const WrittenSegmentation& written);

}  // namespace sline::test
