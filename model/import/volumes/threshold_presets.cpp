// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/threshold_presets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/letters.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

using Brightness = ThresholdPreset::Brightness;

constexpr std::array presets = {
    ThresholdPreset{"bone", 200.0, Brightness::unknown, false, 100.0},
    ThresholdPreset{"skin", -300.0, Brightness::body, true, 1000.0},
    ThresholdPreset{"vessels", 150.0, Brightness::brightest, false, 100.0}};

Error noBounds(std::string reason, std::string remedy) {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

}  // namespace

std::span<const ThresholdPreset> thresholdPresets() {
  return presets;
}

const ThresholdPreset* presetNamed(std::string_view name) {
  const auto found = std::find_if(presets.begin(), presets.end(), [&](const auto& preset) {
    return equalsIgnoringCase(preset.name, name);
  });
  return found == presets.end() ? nullptr : &*found;
}

std::string presetList() {
  std::string list;
  for (std::size_t i = 0; i < presets.size(); ++i)
    list += (i == 0 ? "" : i + 1 < presets.size() ? ", " : " or ") + std::string(presets[i].name);
  return list;
}

Result<IntensityBounds> boundsOf(const Threshold& threshold, bool hounsfield,
                                 const GreyHistogram& histogram) {
  if (threshold.low && threshold.high && !(*threshold.low <= *threshold.high))
    return noBounds("the threshold of \"" + threshold.name + "\" begins above its end",
                    "Give the lower number first");
  if (threshold.low || threshold.high)
    return IntensityBounds{threshold.low, threshold.high};
  const ThresholdPreset* preset = presetNamed(threshold.name);
  if (!preset)
    return noBounds("\"" + threshold.name + "\" has no threshold and is no preset",
                    "Give NAME=VALUE, or " + presetList());
  if (hounsfield)
    return IntensityBounds{preset->hounsfield, {}};
  switch (preset->otherwise) {
    case Brightness::body:
      return IntensityBounds{histogram.otsu(), {}};
    case Brightness::brightest:
      return IntensityBounds{histogram.quantile(0.98, histogram.otsu()), {}};
    case Brightness::unknown:
      break;
  }
  return noBounds(
      "\"" + threshold.name + "\" is known by its Hounsfield units, and the scan is not in them",
      "Give NAME=VALUE with an intensity of the scan");
}

Result<IntensityBounds> boundsOf(const Threshold& threshold, const GreyVolume& volume) {
  const bool counted = !threshold.low && !threshold.high && !volume.hounsfield;
  return boundsOf(threshold, volume.hounsfield, counted ? GreyHistogram(volume) : GreyHistogram());
}

}  // namespace sline::model
