// SPDX-License-Identifier: Apache-2.0
// What a sheet is set on, page by page: a PDF file, or pictures of the same pages.
#pragma once

#include <QPainter>

#include "render/export/description/alt_text.h"
#include "render/export/pdf/pdf_drawing.h"
#include "render/lettering/lettering.h"

namespace sline::render {

class SheetPages {
 public:
  virtual ~SheetPages() = default;
  /// Begins the next page; the first has begun already.
  virtual void newPage() = 0;
  /// Returns the painter of the current page; its unit is a millimetre, from the page's upper left
  /// corner.
  virtual QPainter& painter() = 0;
  /// Places a drawing on the current page, below everything that is painted afterwards; it must
  /// live until the pages are done.
  virtual void place(const VectorDrawing& drawing, const PdfPlacement& place) = 0;
  /// Leaves gaps in the current page's drawings where the lettering has halos and no ground. `at`:
  /// its upper left corner. Who paints on the drawing leaves them by that.
  virtual void leaveGaps(const Lettering&, const glm::vec2& /*at*/) {}
  /// Says what the drawings of the current page show, for who does not see them.
  virtual void describe(const AltText&) {}
};

}  // namespace sline::render
