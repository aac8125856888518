// SPDX-License-Identifier: Apache-2.0
// Summarises what is in a scene, for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "app/cli/files/json_values.h"
#include "model/scene/scene.h"

namespace sline::cli {

struct StructureInfo {
  std::string name;
  std::string group;
  model::MeshPtr mesh;
  bool closed = false;
  std::size_t components = 0;
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
  bool unitDoubted = false;  ///< lengths may be of another unit
  std::vector<StructureInfo> structures;
  std::vector<model::View> views;
  std::vector<AnnotationInfo> annotations;
  std::vector<model::Scan> scans;
};

SceneSummary summaryOf(const model::Scene& scene);

/// Returns "triangles", "vertices", "bounds_mm", "frame", "unit_doubted", "structures", "views",
/// "annotations" and "scans".
Json summaryJson(const SceneSummary& summary, const std::string& frame);
/// Prints one line per structure and one for all, then saved views, annotations and scans; `frame`
/// is printed as given.
void printSummary(const SceneSummary& summary, const std::string& frame);

}  // namespace sline::cli
