// SPDX-License-Identifier: Apache-2.0
// Paints what lies over the drawing into each band of a picture; it is laid out once for all bands.
#pragma once

#include <memory>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

class PageOverlay {
 public:
  /// Creates an overlay and, where the order has text, what setting text needs; `pixels` is the
  /// picture's size.
  static Result<std::unique_ptr<PageOverlay>> create(const ExportOrder& order, glm::ivec2 pixels);
  ~PageOverlay();
  PageOverlay(const PageOverlay&) = delete;
  PageOverlay& operator=(const PageOverlay&) = delete;

  /// Returns what is missing of the overlay.
  const ExportNotes& notes() const;
  /// Paints onto rows that begin `top` rows below the picture's upper edge. It runs on any thread.
  void paint(PixelRows& rows, int top) const;

 private:
  PageOverlay();
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
