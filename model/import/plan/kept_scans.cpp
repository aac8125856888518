// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/kept_scans.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "model/import/naming/file_marks.h"
#include "model/import/naming/laterality.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

namespace {

/// Holds the frame and unit that were decided for the coordinates of a scan's file.
struct Reading {
  std::optional<Frame> frame;
  double unit = 1.0;
  SideEvidence evidence;
};

Reading readingOf(const ReadScan& scan, const std::vector<Part>& parts,
                  const ImportOptions& options) {
  const auto made = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
    return part.file == scan.file && part.raw.threshold;
  });
  if (made != parts.end())
    return {made->frame, double(made->provenance.mmPerUnit), made->provenance.evidence};
  const GreyVolume& volume = *scan.raw.volume;
  const double unit = double(options.unit.value_or(1.0f));
  if (options.frame)
    return {options.frame, unit, {Evidence::settled, Evidence::settled}};
  if (volume.frame)
    return {volume.frame, unit, {}};
  return {std::nullopt,
          unit,
          {Evidence::assumed, volume.onlySideOpen ? Evidence::known : Evidence::assumed}};
}

/// Returns the place of the scan. The file's own coordinates are its LPS turned back to its frame;
/// the decided frame and unit lead on from there.
glm::dmat4 placeOf(const GreyVolume& volume, const Reading& reading) {
  const FrameAxes& spoken = axesOf(volume.frame.value_or(Frame::lps));
  const FrameAxes meant = axesIn(reading.frame.value_or(Frame::lps), volume.onlySideOpen);
  const double sideways = spoken.left == meant.left ? 1.0 : -1.0;
  const double backward = spoken.posterior == meant.posterior ? 1.0 : -1.0;
  glm::dmat4 place = volume.toLps;
  for (int column = 0; column < 4; ++column) {
    place[column].x *= sideways * reading.unit;
    place[column].y *= backward * reading.unit;
    place[column].z *= reading.unit;
  }
  return place;
}

std::string textOf(const std::string& name, const glm::ivec3& size, const glm::dvec3& side) {
  const double bytes = 2.0 * double(size.x) * double(size.y) * double(size.z);
  std::ostringstream text;
  text << name << ", " << size.x << " × " << size.y << " × " << size.z << " voxels of ";
  text.precision(3);
  text << side.x << " × " << side.y << " × " << side.z << " mm, ";
  text.precision(6);
  text << std::max(0.1, std::round(bytes / 1e5) / 10.0) << " MB unpacked";
  return text.str();
}

/// Returns what the scene keeps of the scan's file: slices are called after their scanner, which is
/// no file's name and has no ending.
std::string nameKept(const std::string& file, bool whole) {
  return whole || !std::filesystem::path(file).has_extension() ? file : fileMark(file);
}

}  // namespace

std::vector<Scan> keptScans(const std::vector<ReadScan>& scans, const std::vector<Part>& parts,
                            const ImportOptions& options, ImportReport& report) {
  std::vector<Scan> kept;
  for (const ReadScan& read : scans) {
    const GreyVolume& volume = *read.raw.volume;
    const Reading reading = readingOf(read, parts, options);
    Scan scan{.name = volume.name,
              .file = nameKept(read.raw.file, options.keepFileNames),
              .size = volume.size,
              .toLps = placeOf(volume, reading),
              .slope = volume.slope,
              .intercept = volume.intercept,
              .hounsfield = volume.hounsfield,
              .evidence = reading.evidence};
    // The voxels are those of the scan that was read, which stays as long as they do.
    scan.voxels = VoxelsPtr(read.raw.volume, &volume.voxels);
    if (const std::string fault = scanFault(scan); !fault.empty()) {
      report.warnings.push_back({read.raw.file, "the scan cannot be kept: " + fault});
      continue;
    }
    kept.push_back(std::move(scan));
  }
  return kept;
}

std::string scanText(const Scan& scan) {
  return textOf(scan.name, scan.size, scan.spacing());
}

std::string scanText(const GreyVolume& volume) {
  const glm::dvec3 side(glm::length(glm::dvec3(volume.toLps[0])),
                        glm::length(glm::dvec3(volume.toLps[1])),
                        glm::length(glm::dvec3(volume.toLps[2])));
  return textOf(volume.name, volume.size, side);
}

}  // namespace sline::model
