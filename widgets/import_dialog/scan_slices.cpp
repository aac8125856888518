// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/scan_slices.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/plan/kept_scans.h"

namespace sline::widgets {

namespace {

constexpr int mostPixels = 220;  // along a slice's side

/// Tells which axis of the grid runs along an axis of the patient, and whether backwards.
struct GridAxis {
  int axis = 0;
  bool backwards = false;
};

std::array<GridAxis, 3> patientAxes(const model::GreyVolume& volume) {
  std::array<GridAxis, 3> axes;
  std::array<bool, 3> taken{};
  // The head's direction comes first, because slices are usually acquired across it.
  for (const int along : {2, 0, 1}) {
    double most = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      const glm::dvec3 side = glm::dvec3(volume.toLps[axis]);
      const double share = side[along] / std::max(glm::length(side), 1e-30);
      if (taken[std::size_t(axis)] || std::abs(share) <= most)
        continue;
      most = std::abs(share);
      axes[std::size_t(along)] = {axis, share < 0.0};
    }
    taken[std::size_t(axes[std::size_t(along)].axis)] = true;
  }
  return axes;
}

ScanSlice sliceOf(const model::GreyVolume& volume, const GridAxis& right, const GridAxis& down) {
  const auto sizeAlong = [&](const GridAxis& a) { return volume.size[a.axis]; };
  const auto sideAlong = [&](const GridAxis& a) {
    return glm::length(glm::dvec3(volume.toLps[a.axis]));
  };
  ScanSlice slice;
  slice.width = std::min(sizeAlong(right), mostPixels);
  slice.height = std::min(sizeAlong(down), mostPixels);
  slice.aspect = sideAlong(right) * sizeAlong(right) / slice.width /
                 std::max(sideAlong(down) * sizeAlong(down) / slice.height, 1e-30);
  slice.intensities.reserve(std::size_t(slice.width) * std::size_t(slice.height));
  glm::ivec3 at = volume.size / 2;
  const auto place = [&](const GridAxis& a, int pixel, int pixels) {
    const int voxel = int(std::int64_t(pixel) * sizeAlong(a) / pixels);
    at[a.axis] = a.backwards ? sizeAlong(a) - 1 - voxel : voxel;
  };
  for (int y = 0; y < slice.height; ++y) {
    place(down, y, slice.height);
    for (int x = 0; x < slice.width; ++x) {
      place(right, x, slice.width);
      const std::size_t voxel =
          (std::size_t(at.z) * std::size_t(volume.size.y) + std::size_t(at.y)) *
              std::size_t(volume.size.x) +
          std::size_t(at.x);
      slice.intensities.push_back(
          float(volume.slope * double(volume.voxels[voxel]) + volume.intercept));
    }
  }
  return slice;
}

}  // namespace

ScanFigures scanFiguresOf(const model::ReadScan& scan) {
  const model::GreyVolume& volume = *scan.raw.volume;
  ScanFigures figures;
  figures.file = scan.raw.file;
  figures.text = model::scanText(volume);
  figures.volume = scan.raw.volume;
  figures.histogram = model::GreyHistogram(volume);
  figures.darkest = volume.hounsfield ? -400.0 : figures.histogram.least();
  figures.brightest =
      volume.hounsfield ? 600.0 : figures.histogram.quantile(0.995, figures.histogram.least());
  const auto [left, back, head] = patientAxes(volume);
  const GridAxis feet{head.axis, !head.backwards};
  figures.slices = {sliceOf(volume, left, back), sliceOf(volume, left, feet),
                    sliceOf(volume, back, feet)};
  return figures;
}

QImage tinted(const ScanSlice& slice, const ScanFigures& scan,
              const model::IntensityBounds& bounds) {
  QImage image(slice.width, slice.height, QImage::Format_RGB32);
  const double span = std::max(scan.brightest - scan.darkest, 1e-12);
  const bool any = bounds.low || bounds.high;
  for (int y = 0; y < slice.height; ++y) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < slice.width; ++x) {
      const auto value = double(slice.intensities[std::size_t(y * slice.width + x)]);
      const int grey = int(255.0 * std::clamp((value - scan.darkest) / span, 0.0, 1.0));
      line[x] = any && bounds.contain(value) ? qRgb(150 + grey * 105 / 255, grey * 110 / 255, 30)
                                             : qRgb(grey, grey, grey);
    }
  }
  return image;
}

}  // namespace sline::widgets
