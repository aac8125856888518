// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSlider>

#include "model/focus/context.h"

namespace sline::widgets {

/// A slider from nothing to everything. The handle goes where the mouse is pressed; Escape cancels
/// a drag; keys step.
class AmountSlider : public QSlider {
  Q_OBJECT
 public:
  explicit AmountSlider(QWidget* parent = nullptr);
  void showAmount(model::ContextAmount amount);

 signals:
  void dragged(sline::model::ContextAmount amount);
  void dragFinished();
  void dragCancelled();
  void stepped(sline::model::ContextAmount amount);

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void follow(const QPointF& at);
};

}  // namespace sline::widgets
