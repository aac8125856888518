// SPDX-License-Identifier: Apache-2.0
// How wide lines of labels are, so that the anatomy between their columns is as large as can be.
#pragma once

#include "render/labels/screen.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

/// Labels to be set, each with its place or places in the picture.
struct LabelTexts {
  const std::vector<ShownLabel>& labels;
  const LabelStyle& style;
  const LabelSpace& space;
  LabelBox anatomy;  ///< in the picture
};

/// The widths of columns, without gaps; 0 of one without labels.
struct ColumnWidths {
  float left = 0.0f;
  float right = 0.0f;
  float text = 0.0f;  ///< that lines of text are broken to
};

/// For a camera that is to be fitted between the columns: the anatomy, whose shape alone counts, is
/// as large as it can be, and of widths that let it be about as large the one with the fewest lines
/// is taken.
ColumnWidths widthsBesideFitted(const LabelTexts& texts);

/// For a camera as it is: the columns reach as little into the anatomy as can be, and lines are
/// otherwise long.
ColumnWidths widthsBeside(const LabelTexts& texts);

/// The same for all visible annotations of a scene, from the direction of that screen's camera.
ColumnWidths widthsBesideFitted(const model::Scene& scene, const Screen& screen,
                                const LabelStyle& style);

/// From a column's inner edge to the output's edge there is that much more than its width, and to
/// the anatomy. Millimetres.
float besideColumnMm();

}  // namespace sline::render
