// SPDX-License-Identifier: Apache-2.0
// What an import would do, before it is done.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/import/plan/import.h"

namespace sline::model {

struct ReadInputs;  // read_inputs.h

/// What one node of a plan is to be unlike the others. What is open is as the plan has it: a name,
/// or as the options say.
struct StructureChoice {
  bool include = true;  ///< false: left out; of structures only
  std::optional<std::string> name;
  std::optional<Colour> colour;
  std::optional<Frame> frame;
  std::optional<float> unit;  ///< millimetres per unit
  std::optional<Smoothing> smoothing;
  std::optional<float> decimateMm;  ///< 0: keeps its triangles
  bool operator==(const StructureChoice&) const = default;
};

using StructureChoices = std::map<NodeId, StructureChoice>;

/// A value that can be shown, changed and carried out: the tree of all that could be imported, with
/// each structure's frame and unit and what decided them (Provenance), surfaces as repaired but not
/// yet decimated or, unless their reader makes them smooth, smoothed; in the report what would be
/// left out and why. Who changes `options`, `inputs`, or a frame or unit among the `choices` plans
/// again to see the rest; the tree shows neither what is skipped nor chosen names and colours.
struct ImportPlan {
  std::vector<std::filesystem::path> inputs;
  ImportOptions options;
  Scene scene;
  ImportReport report;
  StructureChoices choices;                  ///< by the ids of `scene`
  std::map<NodeId, std::size_t> parts = {};  ///< which of what was read each structure is
  std::shared_ptr<const ReadInputs> read = nullptr;

  /// What is chosen for the node; as the options say where nothing is.
  StructureChoice choiceOf(NodeId id) const;
};

/// Reads everything; the error is that of importInputs.
Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress = {});

/// The plan after changes, with the choices it has. Files are read again only where inputs, repair
/// or limits are others than they were; a structure that is no more loses its choice.
Result<ImportPlan> planAgain(const ImportPlan& plan, const ImportProgress& progress = {});

/// All structures that came from the same files as these, which are among them; none of scene
/// files.
std::vector<NodeId> ofSameFiles(const ImportPlan& plan, std::span<const NodeId> ids);

/// What of the choices cannot be carried out: ids that are not in the plan, lengths and steps out
/// of range, nothing left to import.
Status checkChoices(const ImportPlan& plan);

/// Imports as planned, under the ids of the plan. Only label volumes and contours that are to be
/// smoothed otherwise than they were are read again. Groups of which nothing is imported are left
/// out.
Result<Imported> carryOut(const ImportPlan& plan, const ImportProgress& progress = {});

}  // namespace sline::model
