// SPDX-License-Identifier: Apache-2.0
#include "widgets/form/longest_text.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QEvent>
#include <QLineEdit>
#include <QPointer>
#include <QToolTip>

namespace sline::widgets {

void sayAt(QWidget& field, const QString& sentence) {
  // What hides a message, such as the keyboard's going elsewhere, comes before this.
  const auto show = [there = QPointer<QWidget>(&field), sentence] {
    constexpr int readable = 6000;  // milliseconds
    if (there && there->isVisible())
      QToolTip::showText(there->mapToGlobal(there->rect().bottomLeft()), sentence, there,
                         there->rect(), readable);
  };
  QMetaObject::invokeMethod(qApp, show, Qt::QueuedConnection);
}

LongestText::LongestText(QObject* parent) : QObject(parent) {
  qApp->installEventFilter(this);
}

void LongestText::say(QWidget& field, int longest) {
  sayAt(field, tr("At most %n characters have room here", nullptr, longest));
}

bool LongestText::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::Polish)
    return false;
  auto* line = qobject_cast<QLineEdit*>(watched);
  // Boxes of numbers judge for themselves.
  if (line && !qobject_cast<QAbstractSpinBox*>(line->parentWidget()))
    connect(line, &QLineEdit::inputRejected, line, [line] {
      if (line->text().size() >= line->maxLength())
        say(*line, line->maxLength());
    });
  return false;
}

}  // namespace sline::widgets

#include "moc_longest_text.cpp"
