// SPDX-License-Identifier: Apache-2.0
// Represents a scanned volume of intensities, as CT and MR give, from which a threshold makes a
// structure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Holds a grid of 16-bit intensities. The intensity of a voxel is slope × stored + intercept, in
/// Hounsfield units where `hounsfield` says so, else in the unit of the scanner.
struct GreyVolume {
  glm::ivec3 size{0};
  std::vector<std::int16_t> voxels;  ///< x fastest
  double slope = 1.0;
  double intercept = 0.0;
  bool hounsfield = false;
  std::string name;       ///< "CT"; never a patient's
  glm::dmat4 toLps{1.0};  ///< indices (a voxel's centre at whole numbers) → mm, LPS; invertible
  std::optional<Frame> frame;  ///< frame in which the file speaks, as LabelVolume::frame
  std::string frameReason;
  bool onlySideOpen = false;  ///< as RawMesh::onlySideOpen
  std::string unitReason;
};

}  // namespace sline::model
