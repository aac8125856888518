// SPDX-License-Identifier: Apache-2.0
// What stands over the drawing: painted into each band of a picture, laid out once for all.
#pragma once

#include <memory>

#include "model/base/result.h"
#include "render/export/order/export_order.h"
#include "render/export/pixels/pixel_rows.h"

namespace sline::render {

class PageOverlay {
 public:
  /// Makes what setting text needs where the order has text; `pixels` is the picture's size.
  static Result<std::unique_ptr<PageOverlay>> create(const ExportOrder& order, glm::ivec2 pixels);
  ~PageOverlay();
  PageOverlay(const PageOverlay&) = delete;
  PageOverlay& operator=(const PageOverlay&) = delete;

  /// What of it is not there.
  const ExportNotes& notes() const;
  /// Onto rows that begin `top` rows below the picture's upper edge. Runs on any thread.
  void paint(PixelRows& rows, int top) const;

 private:
  PageOverlay();
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
