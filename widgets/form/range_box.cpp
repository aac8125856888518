// SPDX-License-Identifier: Apache-2.0
#include "widgets/form/range_box.h"

#include <QLineEdit>

namespace sline::widgets {

RangeBox::RangeBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setKeyboardTracking(false);
  setAlignment(Qt::AlignRight);
  connect(lineEdit(), &QLineEdit::textEdited, this, [this](const QString& text) {
    // A text that was taken back is not typed.
    m_typed = !m_mixed || text != prefix() + textFromValue(value()) + suffix();
  });
  connect(this, &QDoubleSpinBox::editingFinished, this, &RangeBox::finish);
}

void RangeBox::showRange(double low, double high) {
  const QSignalBlocker quiet(this);
  m_low = low;
  m_high = high;
  m_mixed = textFromValue(low) != textFromValue(high);
  setValue(high);
  // The text may have changed although the number has not.
  if (!m_typed)
    lineEdit()->setText(prefix() + textFromValue(value()) + suffix());
}

QString RangeBox::textFromValue(double value) const {
  if (m_mixed && value == this->value())
    return tr("%1 – %2").arg(QDoubleSpinBox::textFromValue(m_low),
                             QDoubleSpinBox::textFromValue(m_high));
  return QDoubleSpinBox::textFromValue(value);
}

QValidator::State RangeBox::validate(QString& text, int& position) const {
  if (m_mixed && text == prefix() + textFromValue(value()) + suffix())
    return QValidator::Acceptable;
  return QDoubleSpinBox::validate(text, position);
}

void RangeBox::stepBy(int steps) {
  m_typed = false;
  if (m_mixed) {
    emit moved(steps * singleStep());
    return;
  }
  QDoubleSpinBox::stepBy(steps);
  emit chosen(value());
}

void RangeBox::finish() {
  if (!std::exchange(m_typed, false))
    return;
  m_mixed = false;
  emit chosen(value());
}

}  // namespace sline::widgets

#include "moc_range_box.cpp"
