// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/measure.h"

namespace sline::bench {

struct Report {
  std::size_t triangles = 0;
  std::size_t structures = 0;
  double importMs = 0.0;
  double preprocessMs = 0.0;
  double baseRssMiB = 0.0;  ///< after the context was made, before the import
  double restRssMiB = 0.0;  ///< after the last frame
  double peakRssMiB = 0.0;  ///< until the last frame, before the yardsticks
  Spread frame;
  Spread moving;  ///< as while the camera moves: lines as ever, surfaces at a third
  Spread lines;
  std::vector<std::pair<std::string, Spread>> passes;
  Spread phong;
  Spread vtkPhong;
  double reopenMs = 0.0;    ///< a scene file's bytes to a scene
  double gammaRatio = 0.0;  ///< a step of one structure's Γ over a picture, the mean of some
  double vectorsMs = 0.0;   ///< lines as paths, hidden ones removed, and fills as shapes
  std::string driver;

  /// Return what memory holds after the last frame, and its peak in units of that.
  double bytesPerTriangle() const;
  double peakRatio() const;
  /// Returns the frame's time over the smaller of both yardsticks.
  double frameRatio() const;
  /// Returns a vector drawing's time over the frame's.
  double vectorsRatio() const;
};

std::string asJson(const Report& report);
std::string asText(const Report& report);

}  // namespace sline::bench
