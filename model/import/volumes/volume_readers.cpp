// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/volume_readers.h"

#include <algorithm>
#include <sstream>

#include "model/base/letters.h"
#include "model/import/source/text_cursor.h"
#include "model/import/volumes/formats/volume_file.h"
#include "model/import/volumes/grey_decoder.h"
#include "model/import/volumes/threshold_presets.h"
#include "model/import/volumes/voxel_decoder.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Opens the volume by the name's ending.
Result<VolumeFile> openVolume(const fs::path& file, const ReadOptions& options) {
  fs::path name = file;
  if (equalsIgnoringCase(name.extension().string(), ".gz"))
    name.replace_extension();
  const std::string ending = name.extension().string();
  const auto is = [&ending](const char* known) { return equalsIgnoringCase(ending, known); };
  if (is(".nrrd") || is(".nhdr"))
    return openNrrd(file, options);
  if (is(".mha") || is(".mhd"))
    return openMetaImage(file, options);
  if (is(".mgh") || is(".mgz"))
    return openMgh(file, options);
  if (is(".mnc"))
    return openMinc(file, options);
  return openNifti(file, options);
}

/// Says of which numbers nobody knows what they mean, though a table lies beside the volume, and
/// that there is more than one volume.
void warnOfLabels(const VolumeFile& file, const fs::path& path, LabelVolumes& labels) {
  const std::string name = path.filename().string();
  const auto nameless = [](const LabelVolume& volume) {
    return volume.labels.size() > 1 &&
           std::all_of(volume.labels.begin(), volume.labels.end(), [](const Label& label) {
             return label.name == "label " + std::to_string(label.value);
           });
  };
  if (std::any_of(labels.volumes.begin(), labels.volumes.end(), nameless))
    if (const std::string table = tableBeside(path); !table.empty())
      labels.warnings.push_back(
          {name, "\"" + table + "\" beside it gives none of its labels a name that is understood"});
  if (labels.volumes.size() > 1 && !file.layersMeant)
    labels.warnings.push_back(
        {name, "holds " + std::to_string(labels.volumes.size()) +
                   " label volumes of one place, as points in time; structures of all of them lie "
                   "over each other"});
}

LabelVolumes labelsOf(const VolumeFile& file, const fs::path& path,
                      std::vector<LabelVolume>&& volumes) {
  for (std::size_t layer = 0; layer < volumes.size(); ++layer) {
    LabelVolume& volume = volumes[layer];
    volume.toLps = file.toLps;
    volume.frame = file.frame;
    volume.frameReason = file.frameReason;
    volume.onlySideOpen = file.onlySideOpen;
    volume.unitReason = file.unitReason;
    nameLabels(volume, file.names(volume, layer));
  }
  LabelVolumes labels{std::move(volumes), file.warnings};
  warnOfLabels(file, path, labels);
  return labels;
}

std::string shortNumber(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Tells whether the values look like Hounsfield units: no value of an MR or PET image is that far
/// below zero.
bool looksLikeHounsfield(const GreyVolume& volume) {
  constexpr double air = -800.0;
  constexpr double dense = 150.0;
  const auto [low, high] = std::minmax_element(volume.voxels.begin(), volume.voxels.end());
  const double a = volume.slope * double(*low) + volume.intercept;
  const double b = volume.slope * double(*high) + volume.intercept;
  return std::min(a, b) <= air && std::max(a, b) >= dense;
}

Result<GreyVolumeRead> greyOf(const VolumeFile& file, const std::string& name,
                              const ReadOptions& options) {
  DecodedGrey grey = TRY(decodeGrey(file.layout, file.stored, options.goesOn));
  GreyVolume& volume = grey.volume;
  volume.toLps = file.toLps;
  volume.frame = file.frame;
  volume.frameReason = file.frameReason;
  volume.onlySideOpen = file.onlySideOpen;
  volume.unitReason = file.unitReason;
  volume.hounsfield = looksLikeHounsfield(volume);
  volume.name = volume.hounsfield ? "CT" : "scan";
  GreyVolumeRead read;
  read.warnings = file.warnings;
  if (file.layout.layers > 1)
    read.warnings.push_back({name, "holds " + std::to_string(file.layout.layers) +
                                       " images of one place; the first was read"});
  if (grey.roundedBy > 0.0)
    read.notes.push_back(name + ": intensities were rounded to 16 bits, by at most " +
                         shortNumber(grey.roundedBy));
  read.volume = std::make_shared<const GreyVolume>(std::move(volume));
  return read;
}

Error named(Error error, const fs::path& file) {
  if (error.file.empty())
    error.file = file.string();
  return error;
}

}  // namespace

Result<VolumeRead> readVolume(const fs::path& file, const ReadOptions& options) {
  const Result<VolumeFile> volume = openVolume(file, options);
  if (!volume)
    return named(volume.error(), file);
  Result<DecodedLabels> labels = decodeLabels(volume->layout, volume->stored, options.goesOn);
  if (!labels)
    return named(labels.error(), file);
  if (labels->image.empty())
    return VolumeRead{labelsOf(*volume, file, std::move(labels->volumes)), {}};
  if (options.thresholds.empty() && !options.keepScans)
    return Error{volume->stored.file,
                 {},
                 "is a scan rather than a label volume: " + labels->image,
                 "Give a threshold that makes a structure of it, or choose the segmentation that "
                 "was made of it"};
  Result<GreyVolumeRead> scan = greyOf(*volume, file.filename().string(), options);
  if (!scan)
    return named(scan.error(), file);
  return VolumeRead{{}, std::move(*scan)};
}

Result<GreyVolumeRead> readGreyVolume(const fs::path& file, const ReadOptions& options) {
  const Result<VolumeFile> volume = openVolume(file, options);
  if (!volume)
    return named(volume.error(), file);
  Result<GreyVolumeRead> scan = greyOf(*volume, file.filename().string(), options);
  if (!scan)
    return named(scan.error(), file);
  return scan;
}

}  // namespace sline::model
