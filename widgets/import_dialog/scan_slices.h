// SPDX-License-Identifier: Apache-2.0
// Computes what the dialog shows of a scan, off the window's thread: three slices through its
// middle, as if the patient faced the reader, and how often each intensity occurs in it.
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

/// A slice with so few pixels that it can be tinted anew at each step of a drag.
struct ScanSlice {
  int width = 0;
  int height = 0;
  double aspect = 1.0;  ///< a pixel's width / height
  std::vector<float> intensities;
};

struct ScanFigures {
  std::string file;  ///< as Threshold::scan
  std::string text;  ///< the scan's scanText
  std::shared_ptr<const model::GreyVolume> volume;
  model::GreyHistogram histogram;
  double darkest = 0.0;  ///< the intensities drawn black and white
  double brightest = 1.0;
  /// Axial, coronal and sagittal slices: the patient's right at the left, the front at the left of
  /// the sagittal, the head above.
  std::array<ScanSlice, 3> slices;
};

ScanFigures scanFiguresOf(const model::ReadScan& scan);

/// Returns the slice in grey with everything within the bounds in colour.
QImage tinted(const ScanSlice& slice, const ScanFigures& scan,
              const model::IntensityBounds& bounds);

}  // namespace sline::widgets
