// SPDX-License-Identifier: Apache-2.0
// Shows a histogram with two bounds that are dragged, or moved by the keyboard: left and right move
// the lower one, with Shift the upper one, with Ctrl tenfold.
#pragma once

#include <QWidget>
#include <cstdint>
#include <vector>

#include "model/import/volumes/threshold_presets.h"

namespace sline::widgets {

class IntensityRange : public QWidget {
  Q_OBJECT
 public:
  explicit IntensityRange(QWidget* parent = nullptr);

  /// Sets the histogram along the axis; counts are shown by their logarithms.
  void setHistogram(const model::GreyHistogram& histogram);
  void setBounds(const model::IntensityBounds& bounds);
  const model::IntensityBounds& bounds() const { return m_bounds; }
  double least() const { return m_least; }
  double greatest() const { return m_greatest; }
  /// Returns where the intensity is drawn, in pixels.
  int placeOf(double intensity) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// Tells that the user has moved a bound.
  void boundsChanged(const sline::model::IntensityBounds& bounds);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double lowShown() const { return m_bounds.low.value_or(m_least); }
  double highShown() const { return m_bounds.high.value_or(m_greatest); }
  void move(bool upper, double to);
  double intensityAt(double pixel) const;

  std::vector<std::uint64_t> m_counts;
  double m_least = 0.0;
  double m_greatest = 1.0;
  model::IntensityBounds m_bounds;
  bool m_upper = false;  ///< the mouse holds the upper bound
};

}  // namespace sline::widgets
