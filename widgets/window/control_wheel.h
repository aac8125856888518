// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

class QWidget;

namespace sline::widgets {

/// Keeps the wheel, which is turned to scroll, from changing values on the way: it turns a slider,
/// a box of numbers or one of choices only once that was clicked and until the keyboard goes
/// elsewhere; else it scrolls what is around, and goes on doing so when that brings such a control
/// under the mouse. Holds for all windows of the program.
class ControlWheel : public QObject {
  Q_OBJECT
 public:
  explicit ControlWheel(QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void follow(const QWidget* focus);

  bool turns(const QWidget* control) const;

  QPointer<QWidget> m_clicked;
  QElapsedTimer m_scrolling;  ///< since the wheel scrolled last; invalid after a click
};

}  // namespace sline::widgets
