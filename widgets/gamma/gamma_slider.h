// SPDX-License-Identifier: Apache-2.0
// A tall slider from silhouette to surface with the stages' names beside it.
#pragma once

#include <QAbstractSlider>

#include "model/edit/emphasis.h"

namespace sline::widgets {

class GammaSlider : public QAbstractSlider {
  Q_OBJECT
 public:
  explicit GammaSlider(QWidget* parent = nullptr);

  /// What the slider stands for: one Γ, or the range over which those of several items lie. `own`
  /// is false where it comes from a group above.
  void showGamma(const model::GammaRange& range, bool own);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;
  /// Where a Γ stands, in the widget's coordinates.
  QPointF pointOf(Gamma gamma) const;

 signals:
  void dragStarted();
  void dragged(sline::Gamma gamma);
  void dragFinished();
  void dragCancelled();
  /// By a key, the wheel or an assistive tool.
  void stepped(sline::Gamma gamma);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  Gamma gammaAt(const QPointF& point) const;
  void paintGroove(QPainter& painter) const;
  void paintStages(QPainter& painter) const;
  void paintHandle(QPainter& painter) const;

  model::GammaRange m_range;
  bool m_own = true;
};

}  // namespace sline::widgets
