// SPDX-License-Identifier: Apache-2.0
// Makes pictures of a sheet's pages, as they look on white paper.
#pragma once

#include <QImage>
#include <memory>
#include <vector>

#include "render/export/pdf/sheet_pages.h"

namespace sline::render {

class PicturePages : public SheetPages {
 public:
  /// Makes pages of that size, so many pixels wide, and begins the first.
  PicturePages(const glm::vec2& sizeMm, int width);
  ~PicturePages() override;
  PicturePages(const PicturePages&) = delete;
  PicturePages& operator=(const PicturePages&) = delete;

  void newPage() override;
  QPainter& painter() override { return *m_painter; }
  void place(const VectorDrawing& drawing, const PdfPlacement& place) override;

  /// Returns the pages; nothing may be painted afterwards.
  std::vector<QImage> finish();

 private:
  qreal m_scale;  ///< pixels to the millimetre
  QSize m_size;
  std::vector<QImage> m_pages;
  std::unique_ptr<QPainter> m_painter;
};

/// Paints the drawing as PDF shows it. The painter's unit must be a millimetre, and it must paint
/// on an image.
void paintDrawing(QPainter& painter, const VectorDrawing& drawing, const PdfPlacement& place);

}  // namespace sline::render
