// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/control_wheel.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace sline::widgets {

namespace {

bool hasValue(const QObject* object) {
  return qobject_cast<const QAbstractSpinBox*>(object) || qobject_cast<const QComboBox*>(object) ||
         (qobject_cast<const QAbstractSlider*>(object) && !qobject_cast<const QScrollBar*>(object));
}

/// Returns the control that the widget is, or is a part of; null where there is none. The list that
/// drops down from a box is a window of its own and scrolls.
QWidget* controlAround(QObject* object) {
  for (auto* widget = qobject_cast<QWidget*>(object); widget; widget = widget->parentWidget()) {
    if (hasValue(widget))
      return widget;
    if (widget->isWindow())
      return nullptr;
  }
  return nullptr;
}

/// Tells whether the widget is the control or a part of it, the list that drops down included.
bool within(const QWidget* control, const QWidget* widget) {
  while (widget && widget != control)
    widget = widget->parentWidget();
  return widget != nullptr;
}

}  // namespace

ControlWheel::ControlWheel(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this,
          [this](QWidget*, QWidget* focus) { follow(focus); });
}

void ControlWheel::follow(const QWidget* focus) {
  // While another program has the keyboard nothing here has it, and the control gets it back.
  if (m_clicked && focus && !within(m_clicked, focus))
    m_clicked.clear();
}

bool ControlWheel::turns(const QWidget* control) const {
  constexpr qint64 oneGesture = 500;  // milliseconds
  const bool scrolls = m_scrolling.isValid() && m_scrolling.elapsed() < oneGesture;
  return control == m_clicked && within(control, QApplication::focusWidget()) && !scrolls;
}

bool ControlWheel::eventFilter(QObject* watched, QEvent* event) {
  switch (event->type()) {
    case QEvent::Polish:
      // A wheel that scrolls past must not take the keyboard either.
      if (auto* widget = qobject_cast<QWidget*>(watched);
          widget && hasValue(widget) && widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus);
      return false;
    case QEvent::MouseButtonPress:
      m_scrolling.invalidate();
      if (QWidget* control = controlAround(watched))
        m_clicked = control;
      return false;
    case QEvent::Wheel: {
      const QWidget* control = controlAround(watched);
      if (control && turns(control))
        return false;
      if (watched->isWidgetType())
        m_scrolling.start();
      if (!control)
        return false;
      event->ignore();
      return true;
    }
    default:
      return false;
  }
}

}  // namespace sline::widgets

#include "moc_control_wheel.cpp"
