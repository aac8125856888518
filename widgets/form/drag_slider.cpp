// SPDX-License-Identifier: Apache-2.0
#include "widgets/form/drag_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace sline::widgets {

DragSlider::DragSlider(Qt::Orientation orientation, QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(orientation);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  connect(this, &QAbstractSlider::valueChanged, this, &DragSlider::stepped);
}

void DragSlider::show(int position) {
  const QSignalBlocker quiet(this);
  setValue(position);
}

bool DragSlider::event(QEvent* event) {
  // While the slider has the keyboard, keys that move it are no shortcuts of the window.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& press = static_cast<const QKeyEvent&>(*event);
    const bool plain = (press.modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
    if (plain && press.key() >= Qt::Key_Home && press.key() <= Qt::Key_PageDown) {
      event->accept();
      return true;
    }
  }
  return QAbstractSlider::event(event);
}

void DragSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  setFocus(Qt::MouseFocusReason);  // so that Escape comes here
  setSliderDown(true);
  m_levels = event->modifiers().testFlag(Qt::ShiftModifier);
  emit dragStarted();
  mouseMoveEvent(event);
}

void DragSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown())
    emit dragged(positionAt(event->position()));
}

void DragSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !isSliderDown())
    return;
  setSliderDown(false);
  emit dragFinished();
}

void DragSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isSliderDown()) {
    setSliderDown(false);
    emit dragCancelled();
    return;
  }
  const bool more = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up;
  const bool less = event->key() == Qt::Key_Left || event->key() == Qt::Key_Down;
  if (more || less) {
    if (!isSliderDown())
      setValue(positionAfter(more ? 1 : -1));
    return;
  }
  QAbstractSlider::keyPressEvent(event);
}

void DragSlider::wheelEvent(QWheelEvent* event) {
  constexpr int notch = 120;
  m_wheel += event->angleDelta().y();
  const int steps = m_wheel / notch;
  m_wheel -= steps * notch;
  if (steps != 0 && !isSliderDown())
    setValue(positionAfter(steps));
  event->accept();
}

void DragSlider::paintHandle(QPainter& painter, const QPointF& at, bool own) const {
  constexpr double radius = 8.0;
  const QColor accent = palette().color(QPalette::Highlight);
  if (hasFocus()) {
    QColor glow = accent;
    glow.setAlpha(70);
    painter.setPen(Qt::NoPen);
    painter.setBrush(glow);
    painter.drawEllipse(at, radius + 5.0, radius + 5.0);
  }
  // A filled handle shows the item's own value; a ring shows one from above, or values that differ
  // from item to item.
  painter.setPen(QPen(accent, 2.0));
  painter.setBrush(own ? accent : palette().color(QPalette::Base));
  painter.drawEllipse(at, radius, radius);
}

}  // namespace sline::widgets

#include "moc_drag_slider.cpp"
