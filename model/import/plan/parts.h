// SPDX-License-Identifier: Apache-2.0
// Holds surfaces on their way from their files to the scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/import/plan/import.h"
#include "model/meshing/repair.h"
#include "model/meshing/smoothing.h"
#include "model/scene/scene.h"

namespace sline::model {

/// The name of a structure whose file has none that may be shown.
inline constexpr std::string_view unnamedStructure = "structure";

/// Holds the decisions made by hand for one surface; a member that is not set follows the options
/// for all.
struct PartChoice {
  std::optional<Frame> frame;
  std::optional<float> unit;
  std::optional<Smoothing> smoothing;
  std::optional<float> decimateMm;
  bool skipped = false;  ///< neither smoothed nor decimated, but counted for the grid of the others
};

/// Describes one surface. `raw` holds positions and triangles until `mesh` takes them.
struct Part {
  std::size_t file = 0;    ///< in Sources::files
  std::size_t number = 0;  ///< index among all parts that were read
  std::string surface;     ///< name within its file, as partNames has it
  std::string name;
  std::string given;     ///< the name before words were left out that may be a person's
  bool nameCut = false;  ///< some were
  RawMesh raw;
  SurfaceMeasure measure;
  RepairReport repair;
  Frame frame = Frame::lps;
  float unit = 1.0f;  ///< millimetres per unit, a guessed one included
  Provenance provenance;
  MeshPtr mesh;
  PartChoice choice;
};

/// Describes a structure of a label volume that was left out, because the folder holds it as a
/// surface, too: it shows where that lies.
struct LeftOutTwin {
  std::string name;
  std::size_t source = 0;  ///< in Sources::sources
  glm::vec3 middle{0.0f};  ///< of its surface, in LPS, millimetres
};

}  // namespace sline::model
