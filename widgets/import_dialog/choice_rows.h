// SPDX-License-Identifier: Apache-2.0
// What can be chosen of frame, unit, smoothing and decimation, as tables: the combo boxes, the
// list's cells and the texts are made from them.
#pragma once

#include <QString>
#include <vector>

#include "model/import/plan/plan.h"
#include "widgets/form/choice_of.h"

namespace sline::widgets {

std::vector<ChoiceOf<model::Frame>> frameRows();
/// Millimetres per unit.
std::vector<ChoiceOf<float>> unitRows();
std::vector<ChoiceOf<model::Smoothing>> smoothingRows();
/// How far a surface may move, in millimetres; 0: all triangles are kept.
std::vector<ChoiceOf<float>> decimationRows();

/// "cm", or "× 12.7" for a length without a name.
QString unitText(float millimetres);
QString smoothingText(const model::Smoothing& smoothing);
QString decimationText(float millimetres);

}  // namespace sline::widgets
