// SPDX-License-Identifier: Apache-2.0
// Surfaces under way from their files to the scene.
#pragma once

#include <optional>
#include <string>

#include "model/import/plan/import.h"
#include "model/meshing/repair.h"
#include "model/meshing/smoothing.h"
#include "model/scene/scene.h"

namespace sline::model {

/// What was decided by hand for one surface; what is open is as for all.
struct PartChoice {
  std::optional<Frame> frame;
  std::optional<float> unit;
  std::optional<Smoothing> smoothing;
  std::optional<float> decimateMm;
  bool skipped = false;  ///< it is neither smoothed nor decimated, but tells of the others' grid
};

/// One surface. `raw` holds positions and triangles until `mesh` takes them.
struct Part {
  std::size_t file = 0;    ///< in Sources::files
  std::size_t number = 0;  ///< among all that were read
  std::string surface;     ///< which of its file's, as partNames has it
  std::string name;
  RawMesh raw;
  SurfaceMeasure measure;
  RepairReport repair;
  Frame frame = Frame::lps;
  float unit = 1.0f;  ///< millimetres per unit, a guessed one included
  Provenance provenance;
  MeshPtr mesh;
  PartChoice choice;
};

}  // namespace sline::model
