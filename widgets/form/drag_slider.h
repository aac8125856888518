// SPDX-License-Identifier: Apache-2.0
// A slider that begins, updates and ends each drag as one transaction: Escape takes it back.
#pragma once

#include <QAbstractSlider>

namespace sline::widgets {

class DragSlider : public QAbstractSlider {
  Q_OBJECT
 public:
  explicit DragSlider(Qt::Orientation orientation, QWidget* parent = nullptr);

  /// Tells whether Shift was down when the drag began: several values are to become equal.
  bool levels() const { return m_levels; }

 signals:
  void dragStarted();
  void dragged(int position);
  void dragFinished();
  void dragCancelled();
  /// Tells that a key, the wheel or an assistive tool has moved the slider.
  void stepped(int position);

 protected:
  virtual int positionAt(const QPointF& point) const = 0;
  /// Returns the position that lies so many steps from where the slider stands.
  virtual int positionAfter(int steps) const { return value() + steps * singleStep(); }
  /// Sets the value without emitting a signal.
  void show(int position);
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  /// Paints the handle, and a glow around it where the slider has the keyboard. `own`: filled
  /// handle.
  void paintHandle(QPainter& painter, const QPointF& at, bool own) const;

 private:
  bool m_levels = false;
  int m_wheel = 0;  ///< wheel movement short of a notch, in eighths of a degree
};

}  // namespace sline::widgets
