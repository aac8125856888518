// SPDX-License-Identifier: Apache-2.0
#include "app/cli/scene_summary.h"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "model/geometry/topology.h"

namespace sline::cli {

SceneSummary summaryOf(const model::Scene& scene) {
  SceneSummary summary;
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    const model::Mesh& mesh = *node.mesh;
    const model::VertexFaces faces(mesh);
    summary.structures.push_back({node.name, scene.groupPath(node.id), node.mesh,
                                  model::countEdges(mesh, faces).closed(),
                                  model::connectedComponents(mesh).count});
    summary.triangles += mesh.triangleCount();
    summary.vertices += mesh.vertexCount();
    summary.bounds.add(mesh.bounds());
  }
  return summary;
}

Json summaryJson(const SceneSummary& summary, const std::string& frame) {
  Json root;
  root["triangles"] = summary.triangles;
  root["vertices"] = summary.vertices;
  root["bounds_mm"] = jsonBox(summary.bounds);
  root["frame"] = frame;
  root["structures"] = Json::array();
  for (const StructureInfo& structure : summary.structures)
    root["structures"].push_back({{"name", structure.name},
                                  {"group", structure.group},
                                  {"bounds_mm", jsonBox(structure.mesh->bounds())},
                                  {"triangles", structure.mesh->triangleCount()},
                                  {"vertices", structure.mesh->vertexCount()},
                                  {"closed", structure.closed},
                                  {"components", structure.components}});
  return root;
}

void printSummary(const SceneSummary& summary, const std::string& frame) {
  std::size_t widest = 9;
  for (const StructureInfo& structure : summary.structures)
    widest = std::max(widest, structure.name.size());
  std::cout << std::left << std::setw(int(widest)) << "structure" << std::right << std::setw(11)
            << "triangles" << std::setw(8) << "closed" << std::setw(7) << "parts"
            << "  group\n";
  for (const StructureInfo& structure : summary.structures)
    std::cout << std::left << std::setw(int(widest)) << structure.name << std::right
              << std::setw(11) << structure.mesh->triangleCount() << std::setw(8)
              << (structure.closed ? "yes" : "no") << std::setw(7) << structure.components << "  "
              << structure.group << '\n';
  const glm::vec3 size = summary.bounds.empty() ? glm::vec3(0.0f) : summary.bounds.size();
  std::cout << summary.structures.size() << " structures, " << summary.triangles << " triangles, "
            << summary.vertices << " vertices, " << std::fixed << std::setprecision(1) << size.x
            << " × " << size.y << " × " << size.z << " mm; frame " << frame << '\n';
}

}  // namespace sline::cli
