// SPDX-License-Identifier: Apache-2.0
// What the dialog shows of a scan, worked out off the window's thread: three slices through its
// middle, as a person stands before the reader, and how often each intensity stands in it.
#pragma once

#include <QImage>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/import/plan/load_parts.h"
#include "model/import/volumes/grey_histogram.h"
#include "model/import/volumes/threshold_presets.h"

namespace sline::widgets {

/// Few enough pixels that it is tinted anew at each step of a drag.
struct ScanSlice {
  int width = 0;
  int height = 0;
  double aspect = 1.0;  ///< how wide a pixel is, in heights of it
  std::vector<float> intensities;
};

struct ScanFigures {
  std::string file;  ///< as Threshold::scan
  std::string text;  ///< scanText of it
  std::shared_ptr<const model::GreyVolume> volume;
  model::GreyHistogram histogram;
  double darkest = 0.0;  ///< what is drawn black, and what white
  double brightest = 1.0;
  /// Axial, coronal, sagittal: the patient's right at the left, the front at the left of the
  /// sagittal, the head above.
  std::array<ScanSlice, 3> slices;
};

ScanFigures scanFiguresOf(const model::ReadScan& scan);

/// The slice in grey with what is within the bounds in colour.
QImage tinted(const ScanSlice& slice, const ScanFigures& scan,
              const model::IntensityBounds& bounds);

}  // namespace sline::widgets
