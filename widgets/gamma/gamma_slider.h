// SPDX-License-Identifier: Apache-2.0
// A tall slider from silhouette to surface, with a tick for each stage.
#pragma once

#include "model/edit/emphasis.h"
#include "widgets/form/drag_slider.h"

namespace sline::widgets {

class GammaSlider : public DragSlider {
  Q_OBJECT
 public:
  explicit GammaSlider(QWidget* parent = nullptr);

  /// Shows one Γ, or the range over which those of several items lie. `own` is false where the
  /// value comes from a group above.
  void showGamma(const model::GammaRange& range, bool own);

  /// Returns the Γ at which the handle stands.
  Gamma middle() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// Returns where a Γ stands, in the widget's coordinates.
  QPointF pointOf(Gamma gamma) const;
  /// Returns the Γ of a position.
  static Gamma gammaOf(int position);

 protected:
  void paintEvent(QPaintEvent* event) override;
  int positionAt(const QPointF& point) const override;

 private:
  void paintGroove(QPainter& painter) const;

  model::GammaRange m_range;
  bool m_own = true;
};

}  // namespace sline::widgets
