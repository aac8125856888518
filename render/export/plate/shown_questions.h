// SPDX-License-Identifier: Apache-2.0
// Decides what can be asked of a picture: whatever asks (sheets, slides, cards, quizzes) asks for
// what one sees there, by this rule alone.
#pragma once

#include <vector>

#include "model/scene/question.h"
#include "render/export/order/export_order.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/label_painter.h"

namespace sline::render {

struct ShownQuestions {
  std::vector<model::Question> questions;
  ExportNotes notes;  ///< labels that nothing asks for, and why
};

/// Returns the questions of the order's test (test_options.h) that its picture can be asked.
/// Labels are left out that are not in the picture, whose place is hidden there, so that their
/// leader is dashed, or of whose structure one sees no more than a speck or a sliver; and questions
/// that have no label left.
ShownQuestions shownQuestions(const ExportOrder& order, model::MeshTrees& trees);

/// Puts the questions in the order of the numbers that the plate gives their labels, as one reads
/// them round the figure; those without one come last, as they were.
void putInOrderOfNumbers(std::vector<model::Question>& questions, const LabelPlate& numbered);

}  // namespace sline::render
