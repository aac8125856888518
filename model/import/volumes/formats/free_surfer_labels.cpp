// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/free_surfer_labels.h"

#include <algorithm>
#include <cctype>

#include "model/base/letters.h"

namespace sline::model {

namespace {

/// Numbers from here on are parcels of atlases, of which the table has one.
constexpr std::int64_t firstParcel = 1'000;

bool nameSaysFreeSurfer(const std::filesystem::path& file) {
  const std::string name = lowerCase(file.filename().string());
  for (const char* word : {"aseg", "aparc", "wmparc", "synthseg"})
    if (name.find(word) != std::string::npos)
      return true;
  return false;
}

bool numbersSayFreeSurfer(const LabelVolume& volume, const LabelNames& names) {
  const auto has = [&volume](std::int64_t value) {
    return std::any_of(volume.labels.begin(), volume.labels.end(),
                       [value](const Label& label) { return label.value == value; });
  };
  return (has(2) || has(3)) && (has(41) || has(42)) &&
         std::all_of(volume.labels.begin(), volume.labels.end(), [&names](const Label& label) {
           return label.value >= firstParcel || names.contains(label.value);
         });
}

}  // namespace

LabelNames freeSurferLabels(const LabelVolume& volume, const std::filesystem::path& file) {
  LabelNames names = labelsInTable(freeSurferTable());
  if (!nameSaysFreeSurfer(file) && !numbersSayFreeSurfer(volume, names))
    names.clear();
  return names;
}

}  // namespace sline::model
