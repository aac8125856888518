// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/import_steps.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/shown_names.h"
#include "model/edit/sides.h"
#include "model/edit/tree.h"
#include "model/focus/twins.h"
#include "model/import/kinds/entry_names.h"
#include "model/import/naming/file_marks.h"
#include "model/import/naming/implausible_sizes.h"
#include "model/import/naming/other_sides.h"
#include "model/import/plan/folder_tree.h"
#include "model/import/plan/frame_decision.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/overlay.h"
#include "model/import/plan/repair_notes.h"
#include "model/import/plan/scene_inputs.h"
#include "model/import/plan/shape_parts.h"
#include "model/import/plan/units.h"
#include "model/import/plan/views_and_annotations.h"
#include "model/scene/scene_limits.h"

namespace sline::model {

namespace {

/// Puts the contents of scene files before the imported scene; returns where its own nodes are
/// then.
NewIds putScenesBefore(Imported& imported, const ReadInputs& read, const ImportOptions& options) {
  if (!read.scenes) {
    NewIds same;
    for (const Node& node : imported.scene.nodes())
      same[node.id] = node.id;
    return same;
  }
  Imported all = *read.scenes;
  all.report.frameAnew = imported.report.frameAnew;
  if (all.report.frameAnew)
    all.scene = withFrameAnew(all.scene, *all.report.frameAnew).scene;
  warnOfOptions(options, all.report.warnings);
  NewIds ids = append(all, std::move(imported));
  imported = std::move(all);
  return ids;
}

/// Returns the scene as it will be: with that which it is put into.
Scene withSurroundings(const Imported& imported, const ImportOptions& options) {
  if (!options.into)
    return imported.scene;
  Scene whole = imported.report.frameAnew
                    ? withFrameAnew(*options.into, *imported.report.frameAnew).scene
                    : *options.into;
  append(whole, imported.scene);
  return whole;
}

Error cancelled() {
  return {.reason = "the import was cancelled"};
}

}  // namespace

void warnOfTwins(const Scene& whole, const ReadInputs& read, const ImportOptions& options,
                 ImportReport& report) {
  const std::vector<Twins> twins = twinsOf(whole);
  std::size_t known = read.scenes ? twinsOf(read.scenes->scene).size() : 0;
  known += options.into ? twinsOf(*options.into).size() : 0;
  const std::string text = twinsText(whole, twins);
  if (twins.size() > known && !read.inputs.empty())
    report.warnings.push_back({read.inputs.front().filename().string(), text});
}

namespace {

/// Says how many names are not whole, and which words they lack. They are for who gives the files;
/// neither the scene nor what is made of it has them.
void tellCutNames(std::size_t count, const std::vector<Part>& parts,
                  const std::vector<std::string>& groups, std::vector<std::string>& notes) {
  constexpr std::size_t mostTold = 5;
  if (count == 0)
    return;
  std::vector<std::string> names = groups;
  for (const Part& part : parts)
    if (part.nameCut)
      names.push_back(part.given);
  std::vector<std::string> words;
  for (const std::string& name : names)
    for (std::string& word : wordsNotShown(name))
      if (std::find(words.begin(), words.end(), word) == words.end())
        words.push_back(std::move(word));
  std::string text = "words and numbers of no anatomy, maybe a person's, left out of names: " +
                     std::to_string(count);
  for (std::size_t i = 0; i < std::min(words.size(), mostTold); ++i)
    text += (i == 0 ? " (\"" : ", \"") + words[i] + '"';
  if (!words.empty())
    text += words.size() > mostTold ? ", …)" : ")";
  notes.push_back(std::move(text));
}

/// Says which structures are too small or too large for a body, of scene files too.
void warnOfSizes(Imported& imported) {
  std::string text = implausibleSizesText(imported.scene);
  if (!text.empty())
    imported.report.warnings.push_back({"", std::move(text)});
}

/// Returns the structures that are not wanted or did not come, and the groups that hold nothing
/// else.
std::vector<NodeId> withEmptyGroups(const Scene& scene, const std::set<NodeId>& gone) {
  std::map<NodeId, std::pair<std::size_t, std::size_t>> below;  // structures, and those of them
                                                                // that are gone
  const std::vector<Node>& nodes = scene.nodes();
  for (std::size_t i = nodes.size(); i-- > 0;) {
    std::pair<std::size_t, std::size_t> own = below[nodes[i].id];
    if (!nodes[i].isGroup())
      own = {1, gone.contains(nodes[i].id) ? 1 : 0};
    below[nodes[i].id] = own;
    below[nodes[i].parent].first += own.first;
    below[nodes[i].parent].second += own.second;
  }
  std::vector<NodeId> ids;
  for (const Node& node : nodes)
    if (const auto& [all, missing] = below[node.id]; all > 0 && all == missing)
      ids.push_back(node.id);
  return ids;
}

/// Removes nodes, locked or not: a lock holds for the scene once it is open, not for nodes that are
/// taken into it.
Scene withoutNodes(Scene scene, std::span<const NodeId> ids) {
  std::set<NodeId> locked;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (std::exchange(node.locked, false))
      locked.insert(node.id);
  scene.setNodes(std::move(nodes));
  Scene left = removed(scene, ids).scene;
  nodes = left.nodes();
  for (Node& node : nodes)
    node.locked = locked.contains(node.id);
  left.setNodes(std::move(nodes));
  return left;
}

/// Leaves marks in place of the names of a structure's file and of its surface there.
void hideNames(const RawMesh& raw, Provenance& provenance) {
  // Without a fingerprint it is no file's name; entries of the Protein Data Bank are no one's.
  if (provenance.fingerprint && !(raw.molecule && isEntryFile(provenance.file)))
    provenance.file = fileMark(provenance.file);
  // Who asks for a threshold names what it makes.
  if (!raw.molecule && !raw.threshold)
    provenance.part = partMark(provenance.part);
  if (raw.molecule && !(raw.groups.empty() || isOfEntry(raw.groups.front())))
    provenance.part = shownMoleculePart(provenance.part);
}

/// Returns the plan's tree with the surfaces that came of it.
Scene withSurfaces(const ImportPlan& plan, std::vector<Part> parts) {
  std::map<std::size_t, Part*> byNumber;
  for (Part& part : parts)
    byNumber[part.number] = &part;
  std::set<NodeId> gone;
  std::vector<Node> nodes = plan.scene.nodes();
  for (Node& node : nodes) {
    const StructureChoice choice = plan.choiceOf(node.id);
    const auto number = plan.parts.find(node.id);
    const auto part = number == plan.parts.end() ? byNumber.end() : byNumber.find(number->second);
    const bool lost = number != plan.parts.end() && part == byNumber.end();
    if (!choice.include || lost)
      gone.insert(node.id);
    if (part != byNumber.end()) {
      node.mesh = std::move(part->second->mesh);
      node.provenance = std::move(part->second->provenance);
      if (!plan.options.keepFileNames)
        hideNames(part->second->raw, node.provenance);
      if (part->second->raw.molecule)
        node.atoms = part->second->raw.molecule->atoms;
    }
    node.name = choice.name.value_or(node.name);
    if (choice.colour)
      node.style.colour = choice.colour;
  }
  Scene scene = plan.scene;
  scene.setNodes(std::move(nodes));
  return gone.empty() ? scene : withoutNodes(std::move(scene), withEmptyGroups(plan.scene, gone));
}

/// Brings what was read within what a scene may hold, and reports what was mended.
Status bringWithinLimits(Imported& imported) {
  std::vector<SceneMending> mended;
  Status counts = bringWithinLimits(imported.scene, mended);
  for (const SceneMending& each : mended)
    imported.report.warnings.push_back({"", each.text()});
  return counts;
}

}  // namespace

DecidedParts decideParts(std::vector<Part> parts, const ReadInputs& read,
                         const ImportOptions& options) {
  ImportReport report;
  report.warnings = read.sources.warnings;
  report.warnings.insert(report.warnings.end(), read.warnings.begin(), read.warnings.end());
  const auto made = [](const Part& part) { return part.raw.threshold.has_value(); };
  if (!options.thresholds.empty() && std::none_of(parts.begin(), parts.end(), made))
    report.warnings.push_back({"", "no threshold made a structure: no scan was read that has it"});
  report.notes = overlayMolecules(parts, options.overlay);
  report.notes.insert(report.notes.end(), read.notes.begin(), read.notes.end());
  report.repairs = repairNotes(parts, read.sources);
  decideFrames(parts, read, options, report);
  decideUnits(parts, read.sources, options, report);
  return {std::move(parts), std::move(report)};
}

ImportPlan layOutTree(const DecidedParts& decided, const ReadInputs& read,
                      const ImportOptions& options) {
  BuiltScene built = buildScene(decided.parts, read.sources, AnatomyTable(), options.keepFileNames);
  const auto numbers = std::move(built.numbers);
  const std::size_t cut = built.cutNames.size() +
                          std::size_t(std::count_if(decided.parts.begin(), decided.parts.end(),
                                                    [](const Part& part) { return part.nameCut; }));
  std::vector<std::string> cutNames = std::move(built.cutNames);
  FurnishedScene furnished = withViewsAndAnnotations(std::move(built), read.sources, options);
  Imported imported{.scene = std::move(furnished.scene), .report = decided.report};
  const std::size_t namesCut = cut + furnished.namesCut;
  tellCutNames(namesCut, decided.parts, cutNames, imported.report.notes);
  imported.scene.setTraces(read.traces);
  const NewIds ids = putScenesBefore(imported, read, options);
  ImportPlan plan{.inputs = read.inputs,
                  .options = options,
                  .scene = std::move(imported.scene),
                  .report = std::move(imported.report),
                  .namesCut = namesCut,
                  .cutNames = std::move(cutNames)};
  for (const auto& [id, number] : numbers)
    plan.parts[ids.at(id)] = number;
  return plan;
}

void warnOfBodies(const Scene& scene, ImportReport& report) {
  for (std::string text : {otherSidesText(scene), mixedScalesText(scene)})
    if (!text.empty())
      report.warnings.push_back({"", std::move(text)});
}

Status checkAnythingLeft(const DecidedParts& decided, const ReadInputs& read) {
  if (decided.parts.empty() && !haveFiducials(read.sources) && !read.scenes && read.scans.empty())
    return nothingRead(read.sources, decided.report.warnings);
  return Unit{};
}

Result<Imported> makeScene(const ImportPlan& plan, DecidedParts decided, const ReadInputs& read,
                           ProgressMeter& meter) {
  std::vector<Part>& parts = decided.parts;
  ImportReport& report = decided.report;
  const ImportOptions& options = plan.options;
  std::vector<Scan> scans = plan.scene.scans();
  if (options.keepScans)
    for (Scan& scan : keptScans(read.scans, parts, options, report))
      scans.push_back(std::move(scan));
  smoothParts(parts, read.sources, options.smoothing, meter);
  if (meter.cancelled())
    return cancelled();
  std::vector<std::string> cutNames;
  tellCutNames(plan.namesCut, parts, plan.cutNames, cutNames);
  const bool wanted = std::any_of(parts.begin(), parts.end(),
                                  [](const Part& part) { return !part.choice.skipped; });
  std::erase_if(parts, [](const Part& part) { return part.choice.skipped; });
  placeParts(parts, read.sources, report.warnings);
  decimateParts(parts, options.decimateMm, meter);
  if (meter.cancelled())
    return cancelled();
  if (wanted)
    TRY(checkAnythingLeft(decided, read));
  Imported imported{.report = std::move(report)};
  imported.report.notes.insert(imported.report.notes.end(), cutNames.begin(), cutNames.end());
  putScenesBefore(imported, read, options);
  imported.scene = withSurfaces(plan, std::move(parts));
  const Scene whole = withSurroundings(imported, options);
  warnOfTwins(whole, read, options, imported.report);
  warnOfSizes(imported);
  warnOfBodies(whole, imported.report);
  markNamesInDoubt(imported.scene, whole);
  imported.scene.setScans(std::move(scans));
  TRY(bringWithinLimits(imported));
  return imported;
}

double expectedWork(const std::vector<Part>& parts, const ImportOptions& options) {
  double work = 1.0;
  for (const Part& part : parts) {
    const double once = double(part.raw.triangles.size()) * workPerTriangle;
    if (part.choice.skipped)
      continue;
    if (part.choice.smoothing.value_or(options.smoothing).mode != Smoothing::Mode::off)
      work += once;
    if (part.choice.decimateMm.value_or(options.decimateMm) > 0.0f)
      work += once;
  }
  return work;
}

}  // namespace sline::model
