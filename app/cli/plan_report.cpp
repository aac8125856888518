// SPDX-License-Identifier: Apache-2.0
#include "app/cli/plan_report.h"

#include <map>
#include <sstream>

#include "app/cli/files/flag_words.h"
#include "app/cli/flags/values.h"
#include "model/lengths/told_length.h"
#include "model/scene/known_frame.h"

namespace sline::cli {

namespace {
Json nodeJson(const model::Node& node) {
  Json json = {{"id", node.id.value}};
  if (node.parent != model::rootId)
    json["parent"] = node.parent.value;
  json["name"] = node.name;
  if (node.isGroup())
    return json;
  const model::Provenance& origin = node.provenance;
  json["file"] = origin.file;
  json["frame"] = origin.frame == model::fileFrame ? origin.frame : "LPS";
  json["read_as"] = origin.frame;
  json["sides"] = model::evidenceNames[std::size_t(origin.evidence.sides)];
  json["front"] = model::evidenceNames[std::size_t(origin.evidence.front)];
  json["up"] = model::evidenceNames[std::size_t(origin.evidence.up)];
  json["frame_reason"] = origin.frameReason;
  json["mm_per_unit"] = jsonNumber(origin.mmPerUnit);
  json["unit_reason"] = origin.unitReason;
  json["triangles"] = node.mesh->triangleCount();
  json["vertices"] = node.mesh->vertexCount();
  json["repaired_faces"] = origin.repairedFaces;
  json["bounds_mm"] = jsonBox(node.mesh->bounds());
  return json;
}

Json doubtJson(const model::UnitDoubt& doubt) {
  Json units = Json::array();
  for (const float unit : doubt.units)
    units.push_back(jsonNumber(unit));
  return {{"file", doubt.file},
          {"named", doubt.named},
          {"fitting", doubt.fitting},
          {"mm_per_unit", jsonNumber(doubt.unit)},
          {"fitting_mm_per_unit", units}};
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string decision(const std::string& answer, const std::string& reason) {
  return reason.empty() ? answer : answer + " (" + reason + ")";
}

std::string frameDecision(const model::Provenance& origin) {
  const std::string frame = decision(origin.frame, origin.frameReason);
  return origin.evidence.isSure() ? frame : frame + ", which is not certain";
}

std::string unitDecision(const model::Provenance& origin) {
  return decision(jsonText(jsonNumber(origin.mmPerUnit)) + " mm", origin.unitReason) +
         (model::isUnitDoubted(origin) ? ", which is not certain" : "");
}

/// Tells how many structures each decision holds for.
template <class Decide>
std::string decisions(const model::Scene& scene, const std::string& title, const Decide& decide) {
  std::map<std::string, std::size_t> counts;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup() && !node.provenance.frame.empty())
      ++counts[decide(node.provenance)];
  std::string text;
  for (const auto& [told, count] : counts)
    text.append(title).append(" ").append(told).append(": ").append(counted(count, "structure")) +=
        '\n';
  return text;
}
}  // namespace

Json planJson(const model::ImportPlan& plan) {
  Json root;
  root["inputs"] = Json::array();
  for (const std::filesystem::path& input : plan.inputs)
    root["inputs"].push_back(input.string());
  root["nodes"] = Json::array();
  for (const model::Node& node : plan.scene.nodes())
    root["nodes"].push_back(nodeJson(node));
  root["bounds_mm"] = jsonBox(plan.scene.visibleBounds());
  root["decimate_mm"] = jsonNumber(plan.options.decimateMm);
  root["left_out"] = Json::array();
  for (const model::ImportWarning& warning : plan.report.warnings)
    root["left_out"].push_back({{"file", warning.file}, {"reason", warning.reason}});
  root["unit_doubts"] = Json::array();
  for (const model::UnitDoubt& doubt : plan.report.unitDoubts)
    root["unit_doubts"].push_back(doubtJson(doubt));
  root["notes"] = plan.report.notes;
  root["repaired"] = plan.report.repairs.surfaces;
  return root;
}

std::string planText(const model::ImportPlan& plan) {
  std::ostringstream out;
  std::map<model::NodeId, std::size_t> depth{{model::rootId, 0}};
  std::size_t triangles = 0;
  std::size_t structures = 0;
  for (const model::Node& node : plan.scene.nodes()) {
    const std::size_t level = depth.at(node.parent);
    depth[node.id] = level + 1;
    out << std::string(2 * level, ' ') << node.name;
    if (!node.isGroup()) {
      const std::string& file = node.provenance.file;
      out << ": " << counted(node.mesh->triangleCount(), "triangle")
          << (file.empty() ? "" : " from " + file);
      triangles += node.mesh->triangleCount();
      ++structures;
    }
    out << '\n';
  }
  out << counted(structures, "structure") << ", " << counted(triangles, "triangle");
  if (const model::Box box = plan.scene.visibleBounds(); !box.empty()) {
    out << ", " << model::toldSize(box.size(), drawnUnit(plan.scene));
  }
  out << '\n'
      << decisions(plan.scene, "frame", frameDecision)
      << decisions(plan.scene, "one unit is", unitDecision);
  if (plan.options.decimateMm > 0.0f)
    out << "triangles will be made fewer, with no part of a surface moved by more than "
        << jsonText(jsonNumber(plan.options.decimateMm)) << " mm\n";
  for (const std::string& note : plan.report.notes)
    out << withFlags(note) << '\n';
  if (!plan.report.repairs.summary.empty())
    out << plan.report.repairs.summary << '\n';
  for (const model::ImportWarning& warning : plan.report.warnings)
    out << "left out or mended: " << (warning.file.empty() ? "" : warning.file + ": ")
        << withFlags(warning.reason) << '\n';
  return out.str();
}

}  // namespace sline::cli
