// SPDX-License-Identifier: Apache-2.0
// Puts what the dialog says about a plan into words.
#pragma once

#include <QString>

#include "widgets/import_dialog/plan_figures.h"

namespace sline::widgets {

/// Returns "28 structures in 5 groups, 42,369 triangles, 1,824 mm".
QString summaryText(const model::ImportPlan& plan, const PlanFigures& figures);
/// Returns why the overall size is unlikely, with the unit that would make it likely; empty where
/// it is not.
QString sizeDoubt(const model::ImportPlan& plan, const PlanFigures& figures);
/// Returns which structures are on the other side than their names say; empty where none is.
QString sideDoubt(const model::ImportPlan& plan, const PlanFigures& figures);
/// Returns what was decided about all frames or units, and why.
QString frameText(const model::ImportPlan& plan);
QString unitReasonText(const model::ImportPlan& plan);
/// Returns where a structure came from, what was decided about it and why.
QString detailsText(const model::ImportPlan& plan, const PlanFigures& figures, model::NodeId id);

/// Returns a length in millimetres in as few characters as can be read.
QString millimetresText(float millimetres);
/// Returns "182 × 90 × 61 mm"; empty for an empty box.
QString boxText(const model::Box& box);

}  // namespace sline::widgets
