// SPDX-License-Identifier: Apache-2.0
// Labels and marks for programs without Qt's headers.
#pragma once

#include <string>
#include <vector>

#include "model/scene/free_sides.h"
#include "render/export/order/export_order.h"
#include "render/lettering/typesetting.h"
#include "render/raster/image.h"

namespace sline::render {

struct LabelReport {
  struct Line {
    int number = 0;
    std::string text;
  };
  std::vector<Line> key;             ///< of all labels in the picture, by number
  std::vector<std::string> leftOut;  ///< texts for which there was no room
};

/// Draws labels and marks over the picture that was drawn of the order's scene; the page's height
/// is the picture's.
LabelReport drawPlate(Image& image, const ExportOrder& order, const Typesetting& typesetting);

/// The same report without a picture.
LabelReport reportOfPlate(const ExportOrder& order, const Typesetting& typesetting);

/// What columns of labels and marks take at the page's sides, for a camera that is to be fitted,
/// whose direction is the order's: each column is as wide as what stands in it, and lines are
/// broken so that the anatomy between them is as large as it can be.
model::FreeSides sidesOfPlate(const ExportOrder& order, const Typesetting& typesetting);

/// The share of the page's width and height that they leave to the anatomy, 0 … 1, from whatever
/// side it is seen.
glm::vec2 shareBesidePlate(const ExportOrder& order, const Typesetting& typesetting);

}  // namespace sline::render
