// SPDX-License-Identifier: Apache-2.0
// What the dialog says of a plan, in words.
#pragma once

#include <QString>

#include "widgets/import_dialog/plan_figures.h"

namespace sline::widgets {

/// "28 structures in 5 groups, 42,369 triangles, 1,824 mm"
QString summaryText(const model::ImportPlan& plan, const PlanFigures& figures);
/// What makes the size as a whole unlikely, with the unit that would make it likely; empty where
/// nothing does.
QString sizeDoubt(const model::ImportPlan& plan, const PlanFigures& figures);
/// Which structures are on the other side than their names say; empty where none is.
QString sideDoubt(const model::ImportPlan& plan, const PlanFigures& figures);
/// What was decided of all frames or units, and why.
QString frameText(const model::ImportPlan& plan);
QString unitReasonText(const model::ImportPlan& plan);
/// Where a structure came from, what was decided about it and why.
QString detailsText(const model::ImportPlan& plan, const PlanFigures& figures, model::NodeId id);

/// A length in millimetres as short as can be read.
QString millimetresText(float millimetres);
/// "182 × 90 × 61 mm"; empty for an empty box.
QString boxText(const model::Box& box);

}  // namespace sline::widgets
