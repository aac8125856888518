// SPDX-License-Identifier: Apache-2.0
// Defines a scanned volume (CT, MR) that is kept with the scene, for slices beside the drawing.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "model/scene/evidence.h"

namespace sline::model {

/// Holds the stored numbers, x fastest; shared by all copies of a scene, as meshes are.
using VoxelsPtr = std::shared_ptr<const std::vector<std::int16_t>>;

/// A scan holds stored numbers; a voxel's intensity is slope × stored + intercept, in Hounsfield
/// units where `hounsfield` says so, else in the unit of the scanner.
struct Scan {
  std::string name;       ///< "CT"
  std::string file;       ///< the file it came from, without its folder
  glm::ivec3 size{0};     ///< voxels along each axis
  glm::dmat4 toLps{1.0};  ///< indices (a voxel's centre at whole numbers) → mm, LPS; affine
  double slope = 1.0;
  double intercept = 0.0;
  bool hounsfield = false;
  SideEvidence evidence;  ///< how sure the directions of `toLps` are
  VoxelsPtr voxels;       ///< as many as `size` implies
  std::string unread;     ///< like Node::unread

  /// Returns the distance in millimetres from voxel to voxel along each axis.
  glm::dvec3 spacing() const;
  double intensity(std::int16_t stored) const { return slope * double(stored) + intercept; }
  bool operator==(const Scan&) const = default;
};

/// A scan may have this many voxels; each takes two bytes.
inline constexpr std::uint64_t mostScanVoxels = std::uint64_t(1) << 31;

/// Returns what is wrong with the scan, as "its size is …", or an empty text if nothing is.
std::string scanFault(const Scan& scan);

}  // namespace sline::model
