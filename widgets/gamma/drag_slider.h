// SPDX-License-Identifier: Apache-2.0
// A slider whose drags begin, go on and end as one transaction: Escape takes them back.
#pragma once

#include <QAbstractSlider>

namespace sline::widgets {

class DragSlider : public QAbstractSlider {
  Q_OBJECT
 public:
  explicit DragSlider(Qt::Orientation orientation, QWidget* parent = nullptr);

 signals:
  void dragStarted();
  void dragged(int position);
  void dragFinished();
  void dragCancelled();
  /// By a key, the wheel or an assistive tool.
  void stepped(int position);

 protected:
  virtual int positionAt(const QPointF& point) const = 0;
  /// So many steps from where the slider stands.
  virtual int positionAfter(int steps) const { return value() + steps * singleStep(); }
  /// Sets the value without anything being emitted.
  void show(int position);
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  /// Groove, handle and a glow where the slider has the keyboard. `own`: filled handle.
  void paintHandle(QPainter& painter, const QPointF& at, bool own) const;

 private:
  int m_wheel = 0;  ///< of a notch, in eighths of a degree
};

}  // namespace sline::widgets
