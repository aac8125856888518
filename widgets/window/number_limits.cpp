// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/number_limits.h"

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>

#include "widgets/form/longest_text.h"
#include "widgets/window/number_line.h"

namespace sline::widgets {

namespace {

/// Returns what the field would hold if the key were taken; empty for keys that type nothing.
QString textAfter(const QLineEdit& line, const QKeyEvent& key) {
  QString typed = key.text();
  if (key.matches(QKeySequence::Paste))
    typed = QGuiApplication::clipboard()->text().trimmed();
  else if (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
    return {};
  if (typed.isEmpty() || !typed.front().isPrint())
    return {};
  QString text = line.text();
  int at = line.cursorPosition();
  if (line.hasSelectedText()) {
    at = line.selectionStart();
    text.remove(at, int(line.selectedText().size()));
  }
  return text.insert(at, typed);
}

QValidator::State judged(const QAbstractSpinBox& box, QString text) {
  int end = int(text.size());
  return box.validate(text, end);
}

/// Returns the sentence; empty for boxes of other things than numbers.
QString limitsOf(const QAbstractSpinBox& box) {
  QString low;
  QString high;
  if (const auto* whole = qobject_cast<const QSpinBox*>(&box)) {
    low = box.locale().toString(whole->minimum());
    high = box.locale().toString(whole->maximum()) + whole->suffix();
  } else if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&box)) {
    low = box.locale().toString(number->minimum(), 'f', number->decimals());
    high = box.locale().toString(number->maximum(), 'f', number->decimals()) + number->suffix();
  } else {
    return {};
  }
  return NumberLimits::tr("Numbers from %1 to %2 can be set here").arg(low, high);
}

}  // namespace

NumberLimits::NumberLimits(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

bool NumberLimits::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::FocusOut)
    return false;
  auto* box = qobject_cast<QAbstractSpinBox*>(watched);
  const QLineEdit* line = box ? lineOf(*box) : nullptr;
  if (!line || line->isReadOnly())
    return false;
  const auto* key = event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event) : nullptr;
  const bool entered = !key || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  const QString text = entered ? line->text() : textAfter(*line, *key);
  if (text.isEmpty())
    return false;
  const QValidator::State state = judged(*box, text);
  if (state == QValidator::Invalid || (entered && state != QValidator::Acceptable))
    sayAt(*box, limitsOf(*box));
  return false;
}

}  // namespace sline::widgets

#include "moc_number_limits.cpp"
