// SPDX-License-Identifier: Apache-2.0
// A slim slider for one number of a style.
#pragma once

#include "widgets/form/drag_slider.h"

namespace sline::widgets {

class StyleSlider : public DragSlider {
  Q_OBJECT
 public:
  /// Makes a slider from 0 to `high`; `power` is as in StyleNumber.
  StyleSlider(double high, double step, double power, QWidget* parent = nullptr);

  void showRange(double low, double high, bool own);
  /// Returns the value at which the handle stands.
  double middle() const { return 0.5 * (m_low + m_up); }
  double valueOf(int position) const;
  QPointF pointOf(double value) const;

  QSize sizeHint() const override { return {110, 26}; }
  QSize minimumSizeHint() const override { return {60, 26}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  int positionAt(const QPointF& point) const override;
  int positionAfter(int steps) const override;

 private:
  int positionOf(double value) const;

  double m_high;
  double m_step;
  double m_power;
  double m_low = 0.0;
  double m_up = 0.0;
  bool m_own = false;
};

}  // namespace sline::widgets
