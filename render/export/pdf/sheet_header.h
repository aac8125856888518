// SPDX-License-Identifier: Apache-2.0
// Begins pages of a sheet: title, kind of page and page number at the edges.
#pragma once

#include "render/export/pdf/sheet_layout.h"
#include "render/export/pdf/sheet_pages.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Counts the pages of one document while they are set.
struct PageCount {
  int page = 0;   ///< the current one's number; 0: none has begun
  int total = 0;  ///< 0: not known yet
};

struct SheetHeader {
  QString title;
  QString kind;  ///< at the title's right: "Self-test"
};

/// Begins the next page and sets its header; returns false where the title had to be shortened.
bool beginSheetPage(SheetPages& pages, PageCount& count, const SheetLayout& layout,
                    const SheetHeader& header);

/// Sets one line of text.
void setLine(QPainter& painter, const QString& text, const glm::vec2& at, float points,
             TextAnchor anchor = TextAnchor::start);
/// Sets it in the ink of secondary text.
void setQuietLine(QPainter& painter, const QString& text, const glm::vec2& at, float points,
                  TextAnchor anchor = TextAnchor::start);

}  // namespace sline::render
