// SPDX-License-Identifier: Apache-2.0
// What stands at a picture's edges: the sides of the body, the view's name, what sections have
// taken away, a scale bar. Text is as large as labels are, in points of the output.
#pragma once

#include "render/export/order/export_order.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Millimetres between marks and the output's edge.
inline constexpr float markMargin = 3.0f;

/// An item for each mark: "side L", "view", "section 1" …, "scale".
struct Marks {
  Lettering lettering;
  EdgeRoom edges;  ///< what they take at each edge, for films, where they come and go
  /// What each takes, with air around it; labels and leaders keep out of it (LabelStyle::reserved).
  std::vector<LabelBox> boxes;
  ExportNotes notes;  ///< what is wanted and not there, or shortened
};

/// Of the order's scene, camera and page those marks that are wanted, in the labels' size and
/// language. Letters stand where a side of the body lies in the picture's plane, as in the window;
/// none where all that is visible comes from files whose directions nobody knows. A mark that the
/// page has no room for is left out. The camera must be without fault.
Marks marksOf(const ExportOrder& order);

/// The painter's unit must be a millimetre, from the picture's upper left corner.
void paintMarks(QPainter& painter, const Marks& marks);

}  // namespace sline::render
