// SPDX-License-Identifier: Apache-2.0
// `sline info`: what is in the files.
#include <algorithm>
#include <iomanip>

#include "app/cli/command.h"
#include "app/cli/json_values.h"
#include "app/cli/values.h"
#include "model/geometry/topology.h"

namespace sline::cli {

namespace {

struct InfoFlags {
  InputFlags input;
  bool json = false;
};

struct StructureInfo {
  std::string name;
  std::string group;
  model::MeshPtr mesh;
  bool closed = false;
  std::size_t components = 0;
};

struct SceneInfo {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  model::Box bounds;
  std::string frame;
  std::vector<StructureInfo> structures;
};

/// The frame all structures were read in; "mixed" where they differ.
std::string frameOf(const model::Imported& imported) {
  std::string frame;
  for (const model::Node& node : imported.scene.nodes()) {
    if (node.isGroup() || node.provenance.frame.empty() || node.provenance.frame == frame)
      continue;
    if (!frame.empty())
      return "mixed";
    frame = node.provenance.frame;
  }
  return frame.empty() ? std::string(frameName(imported.report.frame)) : frame;
}

SceneInfo gather(const model::Imported& imported) {
  SceneInfo info;
  info.frame = frameOf(imported);
  for (const model::Node& node : imported.scene.nodes()) {
    if (node.isGroup())
      continue;
    const model::Mesh& mesh = *node.mesh;
    const model::VertexFaces faces(mesh);
    info.structures.push_back({node.name, imported.scene.groupPath(node.id), node.mesh,
                               model::countEdges(mesh, faces).closed(),
                               model::connectedComponents(mesh).count});
    info.triangles += mesh.triangleCount();
    info.vertices += mesh.vertexCount();
    info.bounds.add(mesh.bounds());
  }
  return info;
}

void printJson(const SceneInfo& info, const std::vector<model::ImportWarning>& warnings) {
  Json root;
  root["triangles"] = info.triangles;
  root["vertices"] = info.vertices;
  root["bounds_mm"] = jsonBox(info.bounds);
  root["frame"] = info.frame;
  root["structures"] = Json::array();
  for (const StructureInfo& structure : info.structures)
    root["structures"].push_back({{"name", structure.name},
                                  {"group", structure.group},
                                  {"bounds_mm", jsonBox(structure.mesh->bounds())},
                                  {"triangles", structure.mesh->triangleCount()},
                                  {"vertices", structure.mesh->vertexCount()},
                                  {"closed", structure.closed},
                                  {"components", structure.components}});
  root["warnings"] = Json::array();
  for (const model::ImportWarning& warning : warnings)
    root["warnings"].push_back({{"file", warning.file}, {"reason", warning.reason}});
  std::cout << jsonText(root, 2) << '\n';
}

void printTable(const SceneInfo& info, const std::string& frameReason) {
  std::size_t widest = 9;
  for (const StructureInfo& structure : info.structures)
    widest = std::max(widest, structure.name.size());
  std::cout << std::left << std::setw(int(widest)) << "structure" << std::right << std::setw(11)
            << "triangles" << std::setw(8) << "closed" << std::setw(7) << "parts"
            << "  group\n";
  for (const StructureInfo& structure : info.structures)
    std::cout << std::left << std::setw(int(widest)) << structure.name << std::right
              << std::setw(11) << structure.mesh->triangleCount() << std::setw(8)
              << (structure.closed ? "yes" : "no") << std::setw(7) << structure.components << "  "
              << structure.group << '\n';
  const glm::vec3 size = info.bounds.empty() ? glm::vec3(0.0f) : info.bounds.size();
  std::cout << info.structures.size() << " structures, " << info.triangles << " triangles, "
            << info.vertices << " vertices, " << std::fixed << std::setprecision(1) << size.x
            << " × " << size.y << " × " << size.z << " mm; frame " << info.frame;
  if (!frameReason.empty())
    std::cout << " (" << frameReason << ")";
  std::cout << '\n';
}

Exit runInfo(const InfoFlags& flags) {
  Result<model::ImportOptions> options = importOptions(flags.input);
  if (!options.ok())
    return complain(options.error(), Exit::wrongUse);
  options->smoothing.mode = model::Smoothing::Mode::off;
  Progress progress;
  const Result<model::Imported> imported = readInputs(flags.input.inputs, *options, progress);
  if (!imported.ok())
    return complain(imported.error(), Exit::failed);
  const SceneInfo info = gather(*imported);
  if (flags.json)
    printJson(info, imported->report.warnings);
  else
    printTable(info, imported->report.frameReason);
  return std::cout.flush() ? Exit::done : Exit::failed;
}

void declareInfo(CLI::App& command, InfoFlags& flags) {
  command.add_option("INPUT", flags.input.inputs, inputHelp)->required();
  command.add_flag("--json", flags.json, "For programs: one JSON object on standard output");
  command.add_option("--frame", flags.input.frame, frameHelp)->type_name("LPS|RAS|file");
  command.footer("Counts are of the surfaces as repaired on reading, without smoothing.");
}

}  // namespace

void addInfo(CLI::App& program, Exit& exit) {
  addCommand<InfoFlags>(program, exit, {"info", "List structures, groups, sizes and warnings"},
                        declareInfo, runInfo);
}

}  // namespace sline::cli
