// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "model/edit/tree.h"
#include "model/import/naming/anatomy_names.h"
#include "model/import/plan/folder_tree.h"
#include "model/import/plan/frame_and_unit.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/overlay.h"
#include "model/import/plan/read_inputs.h"
#include "model/import/plan/repair_notes.h"
#include "model/import/plan/scene_inputs.h"
#include "model/import/plan/views_and_annotations.h"

namespace sline::model {

namespace {

using PartChoices = std::vector<PartChoice>;  // by Part::number

PartChoices partChoices(const ImportPlan& plan) {
  PartChoices chosen(plan.read->parts.size());
  for (const auto& [id, number] : plan.parts) {
    const StructureChoice choice = plan.choiceOf(id);
    chosen[number] = {.frame = choice.frame,
                      .unit = choice.unit,
                      .smoothing = choice.smoothing,
                      .decimateMm = choice.decimateMm,
                      .skipped = !choice.include};
  }
  return chosen;
}

/// What was read of the surfaces, with what was chosen of each.
std::vector<Part> partsOf(const ReadInputs& read, const PartChoices& chosen) {
  std::vector<Part> parts = read.parts;
  for (Part& part : parts)
    part.choice = chosen[part.number];
  return parts;
}

/// Lays molecules over each other and decides frames and units.
ImportReport decide(std::vector<Part>& parts, const ReadInputs& read,
                    const ImportOptions& options) {
  ImportReport report;
  report.warnings = read.sources.warnings;
  report.warnings.insert(report.warnings.end(), read.warnings.begin(), read.warnings.end());
  report.notes = overlayMolecules(parts, options.overlay);
  report.notes.insert(report.notes.end(), read.notes.begin(), read.notes.end());
  report.repairs = repairNotes(parts, read.sources);
  decideFrames(parts, read.sources, options, report);
  decideUnits(parts, read.sources, options, report);
  return report;
}

/// Puts what scene files hold before it, as importInputs does.
NewIds afterScenes(Imported& imported, const ReadInputs& read, const ImportOptions& options) {
  if (!read.scenes) {
    NewIds same;
    for (const Node& node : imported.scene.nodes())
      same[node.id] = node.id;
    return same;
  }
  Imported all = *read.scenes;
  warnOfOptions(options, all.report.warnings);
  NewIds ids = append(all, std::move(imported));
  imported = std::move(all);
  return ids;
}

Result<ImportPlan> planned(std::shared_ptr<const ReadInputs> read, const ImportOptions& options,
                           const PartChoices& chosen) {
  std::vector<Part> parts = partsOf(*read, chosen);
  Imported imported{.report = decide(parts, *read, options)};
  placeParts(parts, read->sources, imported.report.warnings);
  if (parts.empty() && !haveFiducials(read->sources) && !read->scenes && read->scans.empty())
    return nothingRead(read->sources, imported.report.warnings);
  BuiltScene built = buildScene(std::move(parts), read->sources, AnatomyTable());
  const auto numbers = std::move(built.numbers);
  imported.scene = withViewsAndAnnotations(std::move(built), read->sources, options.frame);
  if (options.thresholds.empty())
    for (const ReadScan& scan : read->scans)
      imported.report.notes.push_back(scan.raw.file + ": a scan, of which a threshold can make a " +
                                      "structure: " + scanText(*scan.raw.volume));
  const NewIds ids = afterScenes(imported, *read, options);
  ImportPlan plan{.inputs = read->inputs,
                  .options = options,
                  .scene = std::move(imported.scene),
                  .report = std::move(imported.report)};
  for (const auto& [id, number] : numbers)
    plan.parts[ids.at(id)] = number;
  plan.read = std::move(read);
  return plan;
}

/// Where what was read before is now; nothing where it is no more.
class Renumbering {
 public:
  Renumbering(const ReadInputs& before, const ReadInputs& now) : m_before(before) {
    for (const Part& part : now.parts)
      m_numbers[{now.sources.files[part.file].file, part.surface}] = part.number;
  }
  std::optional<std::size_t> of(std::size_t number) const {
    const Part& part = m_before.parts[number];
    const auto found = m_numbers.find({m_before.sources.files[part.file].file, part.surface});
    return found == m_numbers.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  const ReadInputs& m_before;
  std::map<std::pair<std::filesystem::path, std::string>, std::size_t> m_numbers;
};

Status fault(std::string reason, std::string remedy) {
  return Error{.reason = std::move(reason), .remedy = std::move(remedy)};
}

Status checkChoice(const std::string& name, const StructureChoice& choice) {
  constexpr int mostSteps = 1000;
  constexpr float farthest = 100.0f;
  const std::string of = " of \"" + name + "\"";
  if (choice.unit && !(std::isfinite(*choice.unit) && *choice.unit > 0.0f))
    return fault("the unit" + of + " has no length", "Choose a unit");
  if (choice.smoothing && (choice.smoothing->steps < 0 || choice.smoothing->steps > mostSteps))
    return fault("the steps of smoothing" + of + " are out of range",
                 "Choose 0 to " + std::to_string(mostSteps));
  if (choice.decimateMm && !(*choice.decimateMm >= 0.0f && *choice.decimateMm <= farthest))
    return fault("the bound for decimation" + of + " is out of range", "Choose 0 to 100 mm");
  if (choice.name && normalisedName(*choice.name).find_first_not_of(' ') == std::string::npos)
    return fault("the name" + of + " is empty", "Give it a name");
  return Unit{};
}

/// The structures that are not wanted or did not come, and the groups that hold nothing else.
std::vector<NodeId> absent(const Scene& scene, const std::set<NodeId>& gone) {
  std::map<NodeId, std::pair<std::size_t, std::size_t>> below;  // structures, those of them gone
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

/// Locked or not: a lock holds for the scene once it is open, not for what is taken into it.
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

/// The plan's tree with the surfaces that came of it.
Scene furnished(const ImportPlan& plan, std::vector<Part> parts) {
  std::map<std::size_t, Part*> byNumber;
  for (Part& part : parts)
    byNumber[part.number] = &part;
  std::set<NodeId> gone;
  std::vector<Node> nodes = plan.scene.nodes();
  for (Node& node : nodes) {
    const StructureChoice choice = plan.choiceOf(node.id);
    const auto number = plan.parts.find(node.id);
    const auto part = number == plan.parts.end() ? byNumber.end() : byNumber.find(number->second);
    if (!node.isGroup() &&
        (!choice.include || (number != plan.parts.end() && part == byNumber.end())))
      gone.insert(node.id);
    if (part != byNumber.end()) {
      node.mesh = std::move(part->second->mesh);
      node.provenance = std::move(part->second->provenance);
    }
    node.name = choice.name.value_or(node.name);
    if (choice.colour)
      node.style.colour = choice.colour;
  }
  Scene scene = plan.scene;
  scene.setNodes(std::move(nodes));
  return withoutNodes(scene, absent(plan.scene, gone));
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

}  // namespace

StructureChoice ImportPlan::choiceOf(NodeId id) const {
  const auto found = choices.find(id);
  return found == choices.end() ? StructureChoice() : found->second;
}

Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  Result<ReadInputs> read = readInputs(inputs, options, progress);
  if (!read.ok())
    return read.error();
  const PartChoices none(read->parts.size());
  return planned(std::make_shared<const ReadInputs>(std::move(*read)), options, none);
}

Result<ImportPlan> replanned(const ImportPlan& plan, const ImportProgress& progress) {
  std::shared_ptr<const ReadInputs> read = plan.read;
  if (!read || !read->holdsFor(plan.inputs, plan.options)) {
    Result<ReadInputs> again = readInputs(plan.inputs, plan.options, progress);
    if (!again.ok())
      return again.error();
    read = std::make_shared<const ReadInputs>(std::move(*again));
  } else if (read->options.thresholds != plan.options.thresholds) {
    Result<ReadInputs> again = withThresholds(*read, plan.options.thresholds, progress);
    if (!again.ok())
      return again.error();
    read = std::make_shared<const ReadInputs>(std::move(*again));
  }
  const ReadInputs& before = plan.read ? *plan.read : *read;
  const Renumbering renumbering(before, *read);
  PartChoices chosen(read->parts.size());
  if (plan.read) {
    const PartChoices old = partChoices(plan);
    for (std::size_t number = 0; number < old.size(); ++number)
      if (const auto now = renumbering.of(number))
        chosen[*now] = old[number];
  }
  Result<ImportPlan> next = planned(read, plan.options, chosen);
  if (!next.ok())
    return next;
  std::map<std::size_t, NodeId> ids;
  for (const auto& [id, number] : next->parts)
    ids[number] = id;
  for (const auto& [id, choice] : plan.choices) {
    const auto part = plan.parts.find(id);
    if (part == plan.parts.end()) {
      if (const Node* node = next->scene.find(id); node && !next->parts.contains(id))
        next->choices[id] = choice;
    } else if (const auto now = renumbering.of(part->second); now && ids.contains(*now)) {
      next->choices[ids.at(*now)] = choice;
    }
  }
  return next;
}

std::vector<NodeId> ofSameFiles(const ImportPlan& plan, std::span<const NodeId> ids) {
  std::set<std::size_t> files;
  for (const NodeId id : ids)
    if (const auto own = plan.parts.find(id); own != plan.parts.end())
      files.insert(plan.read->parts[own->second].file);
  std::vector<NodeId> same;
  for (const auto& [id, number] : plan.parts)
    if (files.contains(plan.read->parts[number].file))
      same.push_back(id);
  return same;
}

Status checkChoices(const ImportPlan& plan) {
  for (const auto& [id, choice] : plan.choices) {
    const Node* node = plan.scene.find(id);
    if (!node)
      return fault("something is chosen of structure " + std::to_string(id.value) +
                       ", which the plan does not have",
                   "Plan the import again");
    if (Status checked = checkChoice(node->name, choice); !checked.ok())
      return checked;
  }
  const auto& nodes = plan.scene.nodes();
  const auto isStructure = [](const Node& node) { return !node.isGroup(); };
  const auto wanted = [&](const Node& node) {
    return isStructure(node) && plan.choiceOf(node.id).include;
  };
  if (std::any_of(nodes.begin(), nodes.end(), isStructure) &&
      std::none_of(nodes.begin(), nodes.end(), wanted))
    return fault("all structures are left out", "Include at least one");
  if (plan.read && !plan.read->scans.empty() && nodes.empty() && !plan.options.keepScans)
    return fault("nothing is made of the scan yet",
                 "Make a structure of it by a threshold, or keep it with the scene");
  return Unit{};
}

Result<Imported> carriedOut(const ImportPlan& plan, const ImportProgress& progress) {
  if (!plan.read || !plan.read->holdsFor(plan.inputs, plan.options) ||
      plan.read->options.thresholds != plan.options.thresholds) {
    const Result<ImportPlan> again = replanned(plan, progress);
    if (!again.ok())
      return again.error();
    return carriedOut(*again, progress);
  }
  if (const Status checked = checkChoices(plan); !checked.ok())
    return checked.error();
  const Error cancelled{.reason = "the import was cancelled"};
  const ReadInputs& read = *plan.read;
  std::vector<Part> parts = partsOf(read, partChoices(plan));
  ProgressMeter meter(progress, expectedWork(parts, plan.options));
  std::vector<ImportWarning> lost;
  readAsSmoothed(parts, read, plan.options.smoothing, meter, lost);
  if (meter.cancelled())
    return cancelled;
  Imported imported{.report = decide(parts, read, plan.options)};
  imported.report.warnings.insert(imported.report.warnings.end(), lost.begin(), lost.end());
  std::vector<Scan> scans = plan.scene.scans();
  if (plan.options.keepScans)
    for (Scan& scan : keptScans(read.scans, parts, plan.options, imported.report))
      scans.push_back(std::move(scan));
  smoothParts(parts, read.sources, plan.options.smoothing, meter);
  std::erase_if(parts, [](const Part& part) { return part.choice.skipped; });
  if (meter.cancelled())
    return cancelled;
  placeParts(parts, read.sources, imported.report.warnings);
  decimateParts(parts, plan.options.decimateMm, meter);
  if (meter.cancelled())
    return cancelled;
  afterScenes(imported, read, plan.options);
  imported.scene = furnished(plan, std::move(parts));
  imported.scene.setScans(std::move(scans));
  return imported;
}

}  // namespace sline::model
