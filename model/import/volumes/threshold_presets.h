// SPDX-License-Identifier: Apache-2.0
// Lists the structures that a threshold can make of a scan without a number being known: one table
// for the command line, the dialog and the reader.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "model/import/source/read_options.h"
#include "model/import/volumes/grey_histogram.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

struct ThresholdPreset {
  /// Says how the low bound is found in scans without Hounsfield units.
  enum class Brightness {
    unknown,   ///< not at all: there bone is as dark as air
    body,      ///< where the body is best parted from the air around
    brightest  ///< the brightest fiftieth of the body
  };

  std::string_view name;  ///< the structure's name; anatomical names colour it
  double hounsfield;      ///< the low bound in CT
  Brightness otherwise;
  bool outerSurface;  ///< the largest piece alone, with all that it encloses in axial slices
  double specksMm3;   ///< pieces smaller than this are left out
};

std::span<const ThresholdPreset> thresholdPresets();
/// Returns the preset by its name; case is ignored. Null where there is none.
const ThresholdPreset* presetNamed(std::string_view name);
/// Returns "bone, skin or vessels".
std::string presetList();

/// Holds the bounds of a structure's intensities; at least one of both is there.
struct IntensityBounds {
  std::optional<double> low;
  std::optional<double> high;
  bool contain(double intensity) const {
    return (!low || intensity >= *low) && (!high || intensity <= *high);
  }
};

/// Returns the threshold's own bounds, else those of its preset in this scan. The error says why
/// there are none.
Result<IntensityBounds> boundsOf(const Threshold& threshold, const GreyVolume& volume);
/// Does the same where the histogram is at hand.
Result<IntensityBounds> boundsOf(const Threshold& threshold, bool hounsfield,
                                 const GreyHistogram& histogram);

}  // namespace sline::model
