// SPDX-License-Identifier: Apache-2.0
// A scanned volume (CT, MR) that is kept with the scene, for slices beside the drawing.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace sline::model {

/// Stored numbers, x fastest; shared by all copies of a scene, as meshes are.
using VoxelsPtr = std::shared_ptr<const std::vector<std::int16_t>>;

/// The intensity of a voxel is slope × stored + intercept, in Hounsfield units where `hounsfield`
/// says so, else in the unit of the scanner.
struct Scan {
  std::string name;       ///< "CT"
  std::string file;       ///< that it came from, without its folder
  glm::ivec3 size{0};     ///< voxels along each axis
  glm::dmat4 toLps{1.0};  ///< indices (a voxel's centre at whole numbers) → mm, LPS; affine
  double slope = 1.0;
  double intercept = 0.0;
  bool hounsfield = false;
  VoxelsPtr voxels;    ///< as many as `size` says
  std::string unread;  ///< as Node::unread

  /// Millimetres from voxel to voxel along each axis.
  glm::dvec3 spacing() const;
  double intensity(std::int16_t stored) const { return slope * double(stored) + intercept; }
  bool operator==(const Scan&) const = default;
};

/// Of one voxel there are two bytes.
inline constexpr std::uint64_t mostScanVoxels = std::uint64_t(1) << 31;

/// What is wrong with it, as "its size is …"; empty where nothing is.
std::string scanFault(const Scan& scan);

}  // namespace sline::model
