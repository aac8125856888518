// SPDX-License-Identifier: Apache-2.0
// Computes the figures about a plan's surfaces that the dialog shows, once for each plan and off
// the window's thread, because it looks at every structure.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "model/import/plan/plan.h"

namespace sline::widgets {

struct ScanFigures;  // scan_slices.h

struct StructureFigures {
  std::size_t triangles = 0;  ///< for a group, of all below it
  std::size_t structures = 0;
  model::Box box;          ///< millimetres
  bool otherSide = false;  ///< its name says left and it lies right, or the other way round
};

struct PlanFigures {
  StructureFigures all;
  std::unordered_map<std::uint64_t, StructureFigures> nodes;  ///< by NodeId::value, groups too
  std::vector<model::NodeId> otherSide;
  int sidesAgree = 0;  ///< names that say the side they are on
  /// The frame in which sides would be right, where all structures were read in one frame.
  std::optional<model::Frame> sidesRight;
  bool mirrors = false;    ///< that frame is a mirror image: names of front and back agree already
  bool molecules = false;  ///< nothing but molecules: 1 mm stands for 1 Å
  int entries = 0;         ///< molecules that could be laid over each other
  std::vector<std::shared_ptr<const ScanFigures>> scans;
};

/// Returns the plan's figures. `before` holds those of the previous plan, from which figures that
/// take long and have not changed are taken.
PlanFigures figuresOf(const model::ImportPlan& plan, const PlanFigures& before = {});

/// Returns the longest side of the box; 0 where it is empty.
float extent(const model::Box& box);

}  // namespace sline::widgets
