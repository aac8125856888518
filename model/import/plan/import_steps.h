// SPDX-License-Identifier: Apache-2.0
// Declares the steps that every import takes, planned or not: decide, lay out the tree, make the
// scene.
#pragma once

#include <vector>

#include "model/import/plan/parts.h"
#include "model/import/plan/plan.h"
#include "model/import/plan/read_inputs.h"

namespace sline::model {

/// Holds parts with frames, units and places beside each other decided, and the report of it.
struct DecidedParts {
  std::vector<Part> parts;
  ImportReport report;
};

/// Lays molecules over each other and decides frames and units.
DecidedParts decideParts(std::vector<Part> parts, const ReadInputs& read,
                         const ImportOptions& options);

/// Lays out the tree of the scene files' contents and, below it, of the parts; a structure has the
/// mesh that its part has by now. Neither choices nor `read` are set.
ImportPlan layOutTree(const DecidedParts& decided, const ReadInputs& read,
                      const ImportOptions& options);

/// Returns the error of an import that gave nothing, if no part, point, scan or scene is left.
Status checkAnythingLeft(const DecidedParts& decided, const ReadInputs& read);

/// Adds to the report what the scene as a whole says of sides and scales: names for the other side
/// (other_sides.h), molecules beside anatomy (implausible_sizes.h).
void warnOfBodies(const Scene& scene, ImportReport& report);

/// Says what the files hold twice, by themselves or with what was there before: two versions, or
/// two bodies.
void warnOfTwins(const Scene& whole, const ReadInputs& read, const ImportOptions& options,
                 ImportReport& report);

/// Smooths, places and decimates the parts, and puts them into the plan's tree as chosen. Groups
/// that no longer hold anything are left out. The error is that of importInputs.
Result<Imported> makeScene(const ImportPlan& plan, DecidedParts decided, const ReadInputs& read,
                           ProgressMeter& meter);

/// Returns the work of makeScene, in the units of ProgressMeter::add; never 0.
double expectedWork(const std::vector<Part>& parts, const ImportOptions& options);

}  // namespace sline::model
