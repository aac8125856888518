// SPDX-License-Identifier: Apache-2.0
// Paints what is written over the picture of a card.
#pragma once

#include <QImage>
#include <QPainter>
#include <functional>
#include <set>

#include "render/export/order/export_order.h"
#include "render/export/plate/marks.h"
#include "render/lettering/label_painter.h"
#include "render/raster/image.h"

namespace sline::render {

/// The least size of letters, as a share of the picture's width: as many pixels as letters on a
/// phone that is 360 pixels wide need, of which some are its margins.
inline constexpr float phoneLetters = 0.034f;

/// Returns the size of a card's pictures, pixels.
glm::ivec2 cardPixels(const ExportPage& page);
/// Returns the order with letters that are large enough for a phone.
ExportOrder forPhones(const ExportOrder& order);

/// Lets `paint` paint on the picture in millimetres of the page, and returns it as a PNG with the
/// order's credit.
Result<std::string> paintedPng(const ExportOrder& order, QImage canvas,
                               const std::function<void(QPainter&)>& paint);
/// Paints the labels with question marks in place of the texts of those that are asked for, which
/// have no text there. A mark is as long for each text, so that it gives nothing away. The
/// painter's unit must be a millimetre.
void paintQuestion(QPainter& painter, const LabelPlate& plate,
                   const std::set<model::AnnotationId>& asked, float pageWidthMm);

class CardPainter {
 public:
  explicit CardPainter(const ExportOrder& order) : m_order(order) {}

  /// Returns a PNG of the drawing with its marks.
  Result<std::string> ground(const Image& drawn, const Marks& marks) const;
  /// Returns a PNG of the plate's labels alone; it is clear elsewhere.
  Result<std::string> labels(const LabelPlate& plate) const;
  /// Returns a PNG of what `paintQuestion` paints.
  Result<std::string> question(const LabelPlate& plate,
                               const std::set<model::AnnotationId>& asked) const;

 private:
  const ExportOrder& m_order;
};

/// Returns the plate with those labels alone.
LabelPlate onlyThose(const LabelPlate& plate, const std::set<model::AnnotationId>& those);

}  // namespace sline::render
