// SPDX-License-Identifier: Apache-2.0
// Draws labels and marks for programs without Qt's headers.
#pragma once

#include <string>
#include <vector>

#include "model/camera/free_sides.h"
#include "render/export/order/export_notes.h"
#include "render/export/order/export_order.h"
#include "render/lettering/typesetting.h"
#include "render/raster/image.h"

namespace sline::render {

struct LabelReport {
  struct Line {
    int number = 0;
    std::string text;
  };
  std::vector<Line> key;             ///< covers all labels in the picture, by number
  std::vector<std::string> leftOut;  ///< texts for which there was no room
  ExportNotes marks;                 ///< what marks and the legend lack
};

/// Draws labels and marks over the picture that was drawn of the order's scene; the picture's
/// height counts as the page's.
LabelReport drawPlate(Image& image, const ExportOrder& order, const Typesetting& typesetting);

/// Returns the same report without drawing.
LabelReport reportOfPlate(const ExportOrder& order, const Typesetting& typesetting);

/// Returns how much columns of labels and marks take at the page's sides, for a camera that is yet
/// to be fitted but has the order's direction (`sidesBesideLabels`).
model::FreeSides sidesOfPlate(const ExportOrder& order, const Typesetting& typesetting);

/// Returns the share of the page's width and height that labels and marks leave to the anatomy, 0 …
/// 1, from any side.
glm::vec2 shareBesidePlate(const ExportOrder& order, const Typesetting& typesetting);

}  // namespace sline::render
