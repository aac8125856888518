// SPDX-License-Identifier: Apache-2.0
// Sets the rows of a sheet's lists in type.
#pragma once

#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_pages.h"

namespace sline::render {

struct SheetRow {
  RowKind kind = RowKind::heading;
  QString text;                           ///< plain text; none for a line to write on
  int number = 0;                         ///< 0: none
  bool indented = false;                  ///< leaves room for a number even where it has none
  Colour colour;                          ///< that of a structure
  const VectorDrawing* sample = nullptr;  ///< that of a structure, or of hidden outlines
};

/// Sets the row within a column of that width, from its place on the current page; returns false
/// where the text had to be shortened.
bool setRow(SheetPages& pages, const SheetRow& row, const glm::vec2& at, float width);

/// The ink of secondary text and of rules.
inline constexpr Colour quietInk{96, 96, 96};
inline constexpr Colour ruleInk{170, 170, 170};
inline constexpr Colour textInk{0, 0, 0};
void setRule(QPainter& painter, const glm::vec2& from, float width, float pen = 0.15f);
/// Returns the text, shortened at its end where it is wider than that.
QString elidedText(const QString& text, float points, float width);

}  // namespace sline::render
