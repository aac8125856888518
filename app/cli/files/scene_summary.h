// SPDX-License-Identifier: Apache-2.0
// Summarises what is in a scene, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "app/cli/files/json_values.h"
#include "model/scene/known_frame.h"
#include "model/scene/scene.h"

namespace sline::cli {

struct StructureInfo {
  std::string name;
  std::string group;
  model::MeshPtr mesh;
  bool closed = false;
  std::size_t components = 0;
  std::string frame;   ///< of its box
  std::string readAs;  ///< how its file's coordinates were read
  model::SideEvidence evidence;
};

struct AnnotationInfo {
  std::string kind;
  std::string text;
  std::vector<glm::vec3> places;  ///< LPS, millimetres
  bool visible = true;
};

struct SceneSummary {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  model::Box bounds;
  bool unitDoubted = false;                              ///< lengths may be of another unit
  model::DrawnUnit unit = model::DrawnUnit::millimetre;  ///< that lengths are told in
  std::string frame;   ///< of the bounds: "LPS", "file", or "mixed"
  std::string readAs;  ///< how files were read; "mixed" where they differ
  std::string frameReason;
  bool sided = true;
  model::SideEvidence evidence;  ///< the least sure of all
  std::vector<std::string>
      onOtherSide;  ///< names of those that lie on the other side than they say
  std::vector<StructureInfo> structures;
  std::vector<model::View> views;
  std::vector<AnnotationInfo> annotations;
  std::vector<model::Scan> scans;
};

SceneSummary summaryOf(const model::Scene& scene);

/// Returns "triangles", "vertices", "bounds_mm", "frame" (of the bounds), "read_as" (the frame of
/// the files) with "frame_reason", "sides" and "front" (how sure these are), "unit_doubted", "unit"
/// ("angstrom" where a number of "bounds_mm" stands for one),
/// "on_other_side", "structures", "views", "annotations" and "scans".
Json summaryJson(const SceneSummary& summary);
/// Prints one line per structure and one for all, then saved views, annotations and scans.
void printSummary(const SceneSummary& summary);

}  // namespace sline::cli
