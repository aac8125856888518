// SPDX-License-Identifier: Apache-2.0
// Lists the choices of frame, unit, smoothing and decimation as tables, from which the combo boxes,
// the list's cells and the texts are made.
#pragma once

#include <QString>
#include <vector>

#include "model/import/plan/plan.h"
#include "widgets/form/choice_of.h"

namespace sline::widgets {

std::vector<ChoiceOf<model::Frame>> frameRows();
/// Returns the units with their millimetres per unit.
std::vector<ChoiceOf<float>> unitRows();
std::vector<ChoiceOf<model::Smoothing>> smoothingRows();
/// Returns how far a surface may move, in millimetres; 0 keeps all triangles.
std::vector<ChoiceOf<float>> decimationRows();

/// Returns "cm", or "× 12.7" for a length without a name.
QString unitText(float millimetres);
QString smoothingText(const model::Smoothing& smoothing);
QString decimationText(float millimetres);

}  // namespace sline::widgets
