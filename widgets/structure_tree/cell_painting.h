// SPDX-License-Identifier: Apache-2.0
// How the tree's small controls look, and where in their cells they are.
#pragma once

#include <QPalette>
#include <QRectF>
#include <span>

#include "model/edit/emphasis.h"
#include "model/edit/visibility.h"

class QPainter;

namespace sline::widgets {

/// The inline Γ slider in its cell: a groove, and the number to the right of it.
struct GammaCell {
  QRectF cell;
  QRectF groove() const;
  QRectF number() const;
  double xOf(Gamma gamma) const;
  Gamma gammaAt(double x) const;
};

void paintEye(QPainter& painter, const QRectF& cell, model::Shown shown, const QPalette& palette);
/// One colour, or a few side by side.
void paintSwatch(QPainter& painter, const QRectF& cell, std::span<const QColor> colours,
                 const QPalette& palette);

struct GammaLook {
  model::GammaRange range;
  bool own = false;
  bool selected = false;  ///< the row is, so that the colours must stand on the highlight
};
void paintGamma(QPainter& painter, const GammaCell& cell, const GammaLook& look,
                const QPalette& palette);

}  // namespace sline::widgets
