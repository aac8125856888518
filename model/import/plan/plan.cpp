// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "model/anatomy/body_systems.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/plan/import_steps.h"
#include "model/import/plan/kept_scans.h"
#include "model/import/plan/shape_parts.h"
#include "model/scene/known_frame.h"
#include "model/scene_file/scene_file.h"

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

/// Returns the surfaces that were read, with the choices made for each.
std::vector<Part> partsOf(const ReadInputs& read, const PartChoices& chosen) {
  std::vector<Part> parts = read.parts;
  for (Part& part : parts)
    part.choice = chosen[part.number];
  return parts;
}

Result<ImportPlan> makePlan(std::shared_ptr<const ReadInputs> read, const ImportOptions& options,
                            const PartChoices& chosen) {
  DecidedParts decided = decideParts(partsOf(*read, chosen), *read, options);
  placeParts(decided.parts, read->sources, decided.report.warnings);
  TRY(checkAnythingLeft(decided, *read));
  if (options.thresholds.empty())
    for (const ReadScan& scan : read->scans)
      decided.report.notes.push_back(scan.raw.file + ": a scan, of which a threshold can make a " +
                                     "structure: " + scanText(*scan.raw.volume));
  ImportPlan plan = layOutTree(decided, *read, options);
  if (!options.into)
    warnOfTwins(plan.scene, *read, options, plan.report);
  warnOfBodies(plan.scene, plan.report);
  plan.read = std::move(read);
  return plan;
}

/// Finds where a surface that was read before is now; nothing where it no longer exists.
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

}  // namespace

StructureChoice ImportPlan::choiceOf(NodeId id) const {
  const auto found = choices.find(id);
  return found == choices.end() ? StructureChoice() : found->second;
}

Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress) {
  ReadInputs read = TRY(readInputs(inputs, options, ScansWanted::all, progress));
  const PartChoices none(read.parts.size());
  return makePlan(std::make_shared<const ReadInputs>(std::move(read)), options, none);
}

bool mayHoldScans(std::span<const std::filesystem::path> inputs, const ReadLimits& limits) {
  std::vector<std::filesystem::path> meshes;
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(meshes),
               [](const std::filesystem::path& input) { return !isSceneFile(input); });
  const Sources sources = collectSources(meshes, limits, ScannerSlices::read);
  return std::any_of(sources.files.begin(), sources.files.end(),
                     [](const SourceFile& file) { return file.slice || isVolumeFile(file.file); });
}

Result<ImportPlan> planAgain(const ImportPlan& plan, const ImportProgress& progress) {
  std::shared_ptr<const ReadInputs> read = plan.read;
  if (!read || !read->holdsFor(plan.inputs, plan.options)) {
    ReadInputs again = TRY(readInputs(plan.inputs, plan.options, ScansWanted::all, progress));
    read = std::make_shared<const ReadInputs>(std::move(again));
  } else if (read->options.thresholds != plan.options.thresholds) {
    ReadInputs again = TRY(withThresholds(*read, plan.options.thresholds, progress));
    read = std::make_shared<const ReadInputs>(std::move(again));
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
  ImportPlan next = TRY(makePlan(read, plan.options, chosen));
  std::map<std::size_t, NodeId> ids;
  for (const auto& [id, number] : next.parts)
    ids[number] = id;
  for (const auto& [id, choice] : plan.choices) {
    const auto part = plan.parts.find(id);
    if (part == plan.parts.end()) {
      if (const Node* node = next.scene.find(id); node && !next.parts.contains(id))
        next.choices[id] = choice;
    } else if (const auto now = renumbering.of(part->second); now && ids.contains(*now)) {
      next.choices[ids.at(*now)] = choice;
    }
  }
  return next;
}

bool isRead(const ImportPlan& plan) {
  return plan.read && !plan.read->emptied;
}

ImportPlan withoutContents(const ImportPlan& plan) {
  ImportPlan kept{.inputs = plan.inputs,
                  .options = plan.options,
                  .scene = {},
                  .report = {},
                  .choices = plan.choices,
                  .parts = plan.parts};
  kept.options.into = nullptr;
  if (!plan.read)
    return kept;
  auto names = std::make_shared<ReadInputs>();
  names->inputs = plan.read->inputs;
  names->options = plan.read->options;
  names->options.into = nullptr;
  for (const SourceFile& file : plan.read->sources.files)
    names->sources.files.push_back({.file = file.file});
  for (const Part& part : plan.read->parts) {
    Part& name = names->parts.emplace_back();
    name.file = part.file;
    name.number = part.number;
    name.surface = part.surface;
  }
  names->emptied = true;
  kept.read = std::move(names);
  return kept;
}

void chooseLikelyUnits(ImportPlan& plan) {
  for (const UnitDoubt& doubt : plan.report.unitDoubts)
    if (!doubt.units.empty())
      for (const NodeId id : structuresOf(plan, doubt))
        plan.choices[id].unit = doubt.units.front();
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

std::vector<NodeId> structuresOf(const ImportPlan& plan, const UnitDoubt& doubt) {
  std::vector<NodeId> ids;
  for (const Node& node : plan.scene.nodes()) {
    const Provenance& from = node.provenance;
    if (plan.parts.contains(node.id) && isUnitDoubted(from) && from.mmPerUnit == doubt.unit &&
        (doubt.file.empty() || doubt.file == from.file))
      ids.push_back(node.id);
  }
  return ids;
}

Status checkChoices(const ImportPlan& plan) {
  for (const auto& [id, choice] : plan.choices) {
    const Node* node = plan.scene.find(id);
    if (!node)
      return fault("something is chosen of structure " + std::to_string(id.value) +
                       ", which the plan does not have",
                   "Plan the import again");
    TRY(checkChoice(node->name, choice));
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

Result<Imported> carryOut(const ImportPlan& plan, const ImportProgress& progress) {
  if (!plan.read || !plan.read->holdsFor(plan.inputs, plan.options) ||
      plan.read->options.thresholds != plan.options.thresholds) {
    const ImportPlan again = TRY(planAgain(plan, progress));
    return carryOut(again, progress);
  }
  TRY(checkChoices(plan));
  const ReadInputs& read = *plan.read;
  std::vector<Part> parts = partsOf(read, partChoices(plan));
  ProgressMeter meter(progress, expectedWork(parts, plan.options));
  std::vector<ImportWarning> lost;
  readAsSmoothed(parts, read, plan.options.smoothing, meter, lost);
  if (meter.cancelled())
    return Error{.reason = "the import was cancelled"};
  DecidedParts decided = decideParts(std::move(parts), read, plan.options);
  std::move(lost.begin(), lost.end(), std::back_inserter(decided.report.warnings));
  return makeScene(plan, std::move(decided), read, meter);
}

}  // namespace sline::model
