// SPDX-License-Identifier: Apache-2.0
// Determines where the voxels of an Analyze 7.5 file lie (Mayo Clinic's dbh.h). The format says
// which plane its slices are in and which way they run towards the front and the head; which side
// of the patient comes first it does not say, and programs disagree.
#pragma once

#include <glm/mat4x4.hpp>

namespace sline::model {

struct AnalyzeGeometry {
  /// Maps voxel indices → (x, anterior, superior) in mm; x runs along the voxels from side to side.
  glm::dmat4 toMillimetres{1.0};
  const char* unitReason = "";
};

/// Reads the place from a header of 348 bytes; its numbers are reversed where `swap`. A size of 0,
/// or one that is no number, is 1 mm. The origin is the voxel that SPM counts from 1 where the
/// header has one.
AnalyzeGeometry analyzeGeometry(const char* header, bool swap);

}  // namespace sline::model
