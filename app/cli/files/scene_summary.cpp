// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/scene_summary.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <utility>

#include "app/cli/files/names.h"
#include "model/edit/settled_units.h"
#include "model/geometry/topology.h"
#include "model/import/naming/other_sides.h"
#include "model/import/plan/kept_scans.h"
#include "model/lengths/told_length.h"
#include "model/scene/cut_place.h"
#include "model/scene/known_frame.h"
#include "model/scene/markup.h"

namespace sline::cli {

namespace {
/// Keeps what all have in common.
void join(std::string& all, const std::string& one, bool first) {
  all = first || all == one ? one : "mixed";
}

/// Keeps the less sure of the two.
void join(model::SideEvidence& all, const model::SideEvidence& one) {
  all.sides = std::max(all.sides, one.sides);
  all.front = std::max(all.front, one.front);
  all.up = std::max(all.up, one.up);
}

/// Returns the frame in which a structure lies in the scene.
std::string frameInScene(const model::Provenance& from) {
  return from.frame == model::fileFrame ? from.frame : "LPS";
}
}  // namespace

SceneSummary summaryOf(const model::Scene& scene) {
  SceneSummary summary{.sided = model::knownSides(scene).any};
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    const model::Mesh& mesh = *node.mesh;
    const model::VertexFaces faces(mesh);
    summary.structures.push_back(
        {node.name, scene.groupPath(node.id), node.mesh, model::countEdges(mesh, faces).closed(),
         model::connectedComponents(mesh).count, frameInScene(node.provenance),
         node.provenance.frame, node.provenance.evidence});
    const bool first = summary.structures.size() == 1;
    join(summary.frame, frameInScene(node.provenance), first);
    join(summary.readAs, node.provenance.frame, first);
    join(summary.frameReason, node.provenance.frameReason, first);
    join(summary.evidence, node.provenance.evidence);
    summary.triangles += mesh.triangleCount();
    summary.vertices += mesh.vertexCount();
    summary.bounds.add(mesh.bounds());
  }
  for (const model::NodeId id : model::onOtherSide(scene))
    summary.onOtherSide.push_back(scene.find(id)->name);
  summary.unitDoubted = model::hasDoubtedUnits(scene);
  summary.unit = model::drawnUnit(scene);
  if (summary.unitDoubted)
    summary.unit = model::DrawnUnit::doubtedMillimetre;
  summary.views = scene.views();
  static constexpr std::array<const char*, 4> kinds{"label", "callout", "pin", "distance"};
  for (const model::Annotation& annotation : scene.annotations()) {
    AnnotationInfo info{kinds[std::size_t(annotation.kind)],
                        model::plainText(annotation.kind, annotation.text),
                        {},
                        annotation.visible};
    for (const model::Anchor& anchor : model::pointedAt(annotation))
      if (const auto place = scene.placeOf(anchor))
        info.places.push_back(*place);
    summary.annotations.push_back(std::move(info));
  }
  summary.scans = scene.scans();
  for (const model::Scan& scan : summary.scans)
    join(summary.evidence, scan.evidence);
  if (summary.frame.empty())
    summary.frame = "LPS";
  return summary;
}

namespace {
std::pair<double, double> intensitiesOf(const model::Scan& scan) {
  const auto [low, high] = std::minmax_element(scan.voxels->begin(), scan.voxels->end());
  const double a = scan.intensity(*low);
  const double b = scan.intensity(*high);
  return {std::min(a, b), std::max(a, b)};
}

Json scanJson(const model::Scan& scan) {
  const glm::dvec3 side = scan.spacing();
  const auto [least, greatest] = intensitiesOf(scan);
  return {{"name", scan.name},
          {"file", scan.file},
          {"size", {scan.size.x, scan.size.y, scan.size.z}},
          {"spacing_mm", {side.x, side.y, side.z}},
          {"intensities", {least, greatest}},
          {"hounsfield", scan.hounsfield}};
}
}  // namespace

namespace {
/// Says how sure the sides are; "none" where there are none.
void putSides(Json& json, bool sided, const model::SideEvidence& evidence) {
  json["sides"] = sided ? model::evidenceNames[std::size_t(evidence.sides)] : "none";
  json["front"] = sided ? model::evidenceNames[std::size_t(evidence.front)] : "none";
  json["up"] = sided ? model::evidenceNames[std::size_t(evidence.up)] : "none";
}

Json structureJson(const StructureInfo& structure) {
  Json json = {{"name", structure.name},
               {"group", structure.group},
               {"bounds_mm", jsonBox(structure.mesh->bounds())},
               {"frame", structure.frame},
               {"read_as", structure.readAs},
               {"triangles", structure.mesh->triangleCount()},
               {"vertices", structure.mesh->vertexCount()},
               {"closed", structure.closed},
               {"components", structure.components}};
  putSides(json, structure.frame != model::fileFrame, structure.evidence);
  return json;
}
}  // namespace

Json summaryJson(const SceneSummary& summary) {
  Json root;
  root["triangles"] = summary.triangles;
  root["vertices"] = summary.vertices;
  root["bounds_mm"] = jsonBox(summary.bounds);
  root["frame"] = summary.frame;
  root["read_as"] = summary.readAs;
  root["frame_reason"] = summary.frameReason;
  putSides(root, summary.sided, summary.evidence);
  root["unit_doubted"] = summary.unitDoubted;
  root["unit"] = summary.unit == model::DrawnUnit::angstrom ? "angstrom" : "mm";
  root["on_other_side"] = summary.onOtherSide;
  root["structures"] = Json::array();
  for (const StructureInfo& structure : summary.structures)
    root["structures"].push_back(structureJson(structure));
  root["views"] = Json::array();
  for (const model::View& view : summary.views)
    root["views"].push_back({{"name", view.name},
                             {"looks", view.looks ? view.looks->size() : 0},
                             {"sections", view.sections ? view.sections->size() : 0}});
  root["annotations"] = Json::array();
  for (const AnnotationInfo& annotation : summary.annotations) {
    Json places = Json::array();
    for (const glm::vec3& p : annotation.places)
      places.push_back(jsonPoint(p));
    root["annotations"].push_back({{"kind", annotation.kind},
                                   {"text", annotation.text},
                                   {"places_mm", std::move(places)},
                                   {"visible", annotation.visible}});
  }
  root["scans"] = Json::array();
  for (const model::Scan& scan : summary.scans)
    root["scans"].push_back(scanJson(scan));
  return root;
}

namespace {
/// Prints "scan" and a description of it, a line for each.
void printScans(const SceneSummary& summary) {
  for (const model::Scan& scan : summary.scans) {
    const auto [least, greatest] = intensitiesOf(scan);
    std::cout << std::defaultfloat << std::setprecision(6) << "scan "
              << onOneLine(scan.file.empty() ? scan.name : scan.file) << ": "
              << model::scanText(scan) << "; intensities " << least << " to " << greatest
              << (scan.hounsfield ? " HU" : "") << '\n';
  }
}

void printViewsAndAnnotations(const SceneSummary& summary) {
  if (!summary.views.empty())
    std::cout << "saved views:";
  for (const model::View& view : summary.views)
    std::cout << (&view == &summary.views.front() ? " " : ", ") << '"' << onOneLine(view.name)
              << '"';
  if (!summary.views.empty())
    std::cout << '\n';
  // A tenth of a millimetre in a body, as fine beside its size in a cell.
  const glm::vec3 size = summary.bounds.empty() ? glm::vec3(0.0f) : summary.bounds.size();
  const int decimals = model::toldDecimals(double(std::max({size.x, size.y, size.z})));
  std::cout << std::fixed << std::setprecision(decimals + 1);
  for (const AnnotationInfo& annotation : summary.annotations) {
    std::cout << annotation.kind << " \"" << onOneLine(annotation.text) << '"';
    for (const glm::vec3& p : annotation.places)
      std::cout << (&p == &annotation.places.front() ? " at (" : " to (") << p.x << ", " << p.y
                << ", " << p.z << ')';
    std::cout << (annotation.visible ? "\n" : ", hidden\n");
  }
}
}  // namespace

namespace {
/// Returns "; read as RAS (vote: 20 of 22 left/right names)".
std::string readAsText(const SceneSummary& summary) {
  if (summary.readAs.empty() || summary.readAs == "mixed")
    return summary.readAs.empty() ? "" : "; read in several frames";
  std::string text = "; read as " + summary.readAs;
  if (!summary.frameReason.empty() && summary.frameReason != "mixed")
    text += " (" + summary.frameReason + ")";
  return text;
}
}  // namespace

void printSummary(const SceneSummary& summary) {
  std::size_t widest = 9;
  for (const StructureInfo& structure : summary.structures)
    widest = std::max(widest, structure.name.size());
  std::cout << std::left << std::setw(int(widest)) << "structure" << std::right << std::setw(11)
            << "triangles" << std::setw(8) << "closed" << std::setw(7) << "parts"
            << "  group\n";
  for (const StructureInfo& structure : summary.structures)
    std::cout << std::left << std::setw(int(widest)) << onOneLine(structure.name) << std::right
              << std::setw(11) << structure.mesh->triangleCount() << std::setw(8)
              << (structure.closed ? "yes" : "no") << std::setw(7) << structure.components << "  "
              << onOneLine(structure.group) << '\n';
  const glm::vec3 size = summary.bounds.empty() ? glm::vec3(0.0f) : summary.bounds.size();
  std::cout << summary.structures.size() << " structures, " << summary.triangles << " triangles, "
            << summary.vertices << " vertices, " << model::toldSize(size, summary.unit) << " in "
            << summary.frame << readAsText(summary) << '\n';
  printViewsAndAnnotations(summary);
  printScans(summary);
}

}  // namespace sline::cli
