// SPDX-License-Identifier: Apache-2.0
#include "widgets/focus/amount_slider.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>

namespace sline::widgets {

namespace {
constexpr int whole = 100;

model::ContextAmount amountOf(int value) {
  return model::ContextAmount::clamped(float(value) / float(whole));
}
}  // namespace

AmountSlider::AmountSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, whole);
  setSingleStep(1);
  setPageStep(10);
  connect(this, &QAbstractSlider::actionTriggered, this, [this](int action) {
    if (action != SliderMove && action != SliderNoAction)
      emit stepped(amountOf(sliderPosition()));
  });
}

void AmountSlider::showAmount(model::ContextAmount amount) {
  if (isSliderDown())
    return;
  const QSignalBlocker quiet(this);
  setValue(qRound(float(whole) * amount.value()));
}

bool AmountSlider::event(QEvent* event) {
  // Home and Escape belong to the slider while it has the focus, and are no shortcuts of the
  // window.
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Home || key == Qt::Key_End || (key == Qt::Key_Escape && isSliderDown())) {
      event->accept();
      return true;
    }
  }
  return QSlider::event(event);
}

void AmountSlider::follow(const QPointF& at) {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect groove =
      style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const int handle =
      style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
  const int value = QStyle::sliderValueFromPosition(minimum(), maximum(),
                                                    qRound(at.x()) - groove.x() - handle / 2,
                                                    groove.width() - handle, option.upsideDown);
  {
    const QSignalBlocker quiet(this);
    setValue(value);
  }
  emit dragged(amountOf(value));
}

void AmountSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  setSliderDown(true);
  follow(event->position());
}

void AmountSlider::mouseMoveEvent(QMouseEvent* event) {
  if (isSliderDown())
    follow(event->position());
}

void AmountSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !isSliderDown())
    return;
  setSliderDown(false);
  emit dragFinished();
}

void AmountSlider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isSliderDown()) {
    setSliderDown(false);
    emit dragCancelled();
    return;
  }
  QSlider::keyPressEvent(event);
}

}  // namespace sline::widgets

#include "moc_amount_slider.cpp"
