// SPDX-License-Identifier: Apache-2.0
// Chooses how wide lines of labels are, so that the anatomy between their columns is as large as
// possible.
#pragma once

#include "render/labels/seen/screen.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

/// Holds labels to be set, each with its place or places in the picture.
struct LabelTexts {
  const std::vector<ShownLabel>& labels;
  const LabelStyle& style;
  const LabelSpace& space;
  LabelBox anatomy;  ///< the anatomy's extent in the picture
};

/// The widths of columns, without gaps; 0 for a column without labels.
struct ColumnWidths {
  float left = 0.0f;
  float right = 0.0f;
  float text = 0.0f;  ///< the width to which lines of text are broken
};

/// Returns the widths for a camera that is yet to be fitted between the columns. The anatomy, of
/// which only the shape counts, becomes as large as possible; of widths that make it about as
/// large, those with the fewest lines are taken.
ColumnWidths widthsBesideFitted(const LabelTexts& texts);

/// Returns the widths for a camera as it is: the columns reach as little into the anatomy as
/// possible, and lines are otherwise long.
ColumnWidths widthsBeside(const LabelTexts& texts);

/// Does the same as `widthsBesideFitted` above, but for all visible annotations of a scene, from
/// the direction of that screen's camera.
ColumnWidths widthsBesideFitted(const model::Scene& scene, const Screen& screen,
                                const LabelStyle& style);

/// Returns the space besides a column's width from its inner edge to the output's edge, and to the
/// anatomy. Millimetres.
float besideColumnMm();

}  // namespace sline::render
