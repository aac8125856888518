// SPDX-License-Identifier: Apache-2.0
// Describes what an import would do, before it is done.
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

/// Says how one node of a plan is to differ from the others. Members that are not set are as the
/// plan has them: a name, or as the options say.
struct StructureChoice {
  bool include = true;  ///< false: left out; for structures only
  std::optional<std::string> name;
  std::optional<Colour> colour;
  std::optional<Frame> frame;
  std::optional<float> unit;  ///< millimetres per unit
  std::optional<Smoothing> smoothing;
  std::optional<float> decimateMm;  ///< 0: keeps its triangles
  bool operator==(const StructureChoice&) const = default;
};

using StructureChoices = std::map<NodeId, StructureChoice>;

/// Is a value that can be shown, changed and carried out. It holds the tree of everything that
/// could be imported, with each structure's frame and unit and the reason for them (Provenance),
/// and surfaces as repaired but not yet decimated or, unless their reader makes them smooth,
/// smoothed; the report says what would be left out and why. After a change to `options`, `inputs`,
/// or a frame or unit among the `choices`, the caller plans again to see the rest; the tree shows
/// neither skipping nor chosen names and colours.
struct ImportPlan {
  std::vector<std::filesystem::path> inputs;
  ImportOptions options;
  Scene scene;
  ImportReport report;
  StructureChoices choices;                  ///< by the ids of `scene`
  std::map<NodeId, std::size_t> parts = {};  ///< index of the part that each structure is
  std::shared_ptr<const ReadInputs> read = nullptr;
  std::size_t namesCut = 0;  ///< names from which words were left out that may be a person's
  std::vector<std::string> cutNames = {};  ///< those of groups, whole: for who gives the files

  /// Returns the choices made for the node; as the options say where there are none.
  StructureChoice choiceOf(NodeId id) const;
};

/// Reads everything; the error is that of importInputs.
Result<ImportPlan> planImport(std::span<const std::filesystem::path> inputs,
                              const ImportOptions& options, const ImportProgress& progress = {});

/// Tells whether any of the inputs is of a kind that scans are written in.
bool mayHoldScans(std::span<const std::filesystem::path> inputs, const ReadLimits& limits);

/// Plans again after changes, with the choices of the plan. Files are read again only where inputs,
/// repair or limits differ from before; a structure that no longer exists loses its choice.
Result<ImportPlan> planAgain(const ImportPlan& plan, const ImportProgress& progress = {});

/// Returns the plan without what was read, small enough to be kept: it is planned again with its
/// inputs, options and choices when it is wanted.
ImportPlan withoutContents(const ImportPlan& plan);

/// Tells whether the plan has read what there is to read.
bool isRead(const ImportPlan& plan);

/// Takes the likeliest unit for all structures whose unit is in doubt and has one.
void chooseLikelyUnits(ImportPlan& plan);

/// Returns all structures that came from the same files as these, including these; none that came
/// from scene files.
std::vector<NodeId> ofSameFiles(const ImportPlan& plan, std::span<const NodeId> ids);

/// Returns the structures whose unit the doubt is about.
std::vector<NodeId> structuresOf(const ImportPlan& plan, const UnitDoubt& doubt);

/// Tells which choices cannot be carried out: ids that are not in the plan, lengths and steps out
/// of range, nothing left to import.
Status checkChoices(const ImportPlan& plan);

/// Imports as planned, under the ids of the plan. Only label volumes and contours that are to be
/// smoothed otherwise than before are read again. Groups of which nothing is imported are left out.
Result<Imported> carryOut(const ImportPlan& plan, const ImportProgress& progress = {});

}  // namespace sline::model
