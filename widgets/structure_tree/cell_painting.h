// SPDX-License-Identifier: Apache-2.0
// Paints the tree's small controls and computes where in their cells they are.
#pragma once

#include <QColor>
#include <QPalette>
#include <QRectF>
#include <vector>

#include "model/edit/emphasis.h"
#include "model/edit/visibility.h"
#include "widgets/structure_tree/row_states.h"

class QPainter;

namespace sline::widgets {

/// Locates the inline Γ slider in its cell: a groove, and the number to the right of it.
struct GammaCell {
  QRectF cell;
  QRectF groove() const;
  QRectF number() const;
  double xOf(Gamma gamma) const;
  Gamma gammaAt(double x) const;
};

void paintEye(QPainter& painter, const QRectF& cell, model::Visibility shown,
              const QPalette& palette);
struct SwatchState {
  std::vector<QColor> colours;  ///< one, or a few side by side
  float opacity = 1.0f;         ///< below 1 the lower half is as faint
  bool own = false;             ///< smaller where it comes from the group above
};
void paintSwatch(QPainter& painter, const QRectF& cell, const SwatchState& state,
                 const QPalette& palette);
/// Paints a padlock, faint where the group above is locked. Paints nothing for an open row, or an
/// open padlock while the mouse is over it.
void paintLock(QPainter& painter, const QRectF& cell, RowLock lock, bool underMouse,
               const QPalette& palette);
/// Paints where dragged rows would go: a line, or a frame around the group that would take them.
void paintDropMark(QPainter& painter, const QRectF& mark, bool into, const QPalette& palette);

struct GammaState {
  model::GammaRange range;
  bool own = false;
  bool selected = false;  ///< the row is selected, so the colours must contrast with the highlight
  bool locked = false;    ///< no handle: there is nothing to drag
};
void paintGamma(QPainter& painter, const GammaCell& cell, const GammaState& state,
                const QPalette& palette);

}  // namespace sline::widgets
