// SPDX-License-Identifier: Apache-2.0
// Draws the curve from a scalar to what is added to Γ, and lets its points be dragged: one
// transaction for each drag, which Escape takes back.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "model/scene/gamma_map.h"

namespace sline::widgets {

class GammaCurve : public QWidget {
  Q_OBJECT
 public:
  explicit GammaCurve(QWidget* parent = nullptr);

  /// Shows the curve without emitting a signal.
  void showCurve(model::GammaScalar scalar, const std::vector<model::GammaPoint>& points);
  const std::vector<model::GammaPoint>& points() const { return m_points; }
  /// Returns where a point lies in the widget.
  QPointF placeOf(const model::GammaPoint& point) const;

  QSize sizeHint() const override { return {200, 120}; }
  QSize minimumSizeHint() const override { return {120, 100}; }

 signals:
  void dragStarted();
  void dragged();
  void dragFinished();
  void dragCancelled();
  /// Tells that a key or a double click has changed the curve.
  void changed();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF field() const;
  model::GammaPoint pointAt(const QPointF& place) const;
  std::optional<std::size_t> pointNear(const QPointF& place) const;
  /// Moves a point there, or as far as its neighbours let it.
  void moveTo(std::size_t which, model::GammaPoint to);
  bool moveByKey(int key, float step);
  bool add(const model::GammaPoint& point);
  bool remove(std::size_t which);
  void choose(std::size_t which);

  model::GammaScalar m_scalar = model::GammaScalar::none;
  std::vector<model::GammaPoint> m_points;
  Limits<float> m_range{0.0f, 1.0f};  ///< of the scalar, from left to right
  std::size_t m_chosen = 0;
  bool m_dragging = false;
};

}  // namespace sline::widgets
