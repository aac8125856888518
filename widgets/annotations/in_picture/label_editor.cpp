// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/in_picture/label_editor.h"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

namespace sline::widgets {

LabelEditor::LabelEditor(QWidget* picture) : LabelField(picture) {
  setObjectName(QStringLiteral("labelText"));
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setTabChangesFocus(true);
  document()->setDocumentMargin(3.0);
  connect(this, &QPlainTextEdit::textChanged, this, &LabelEditor::fit);
  hide();
}

void LabelEditor::open(const QPoint& place, const Words& words) {
  setAccessibleName(tr("What the label says"));
  setMarkup(words.lines);
  setToolTip(words.lines ? tr("Return takes it over, Shift+Return begins a line, Esc forgets it") +
                               QLatin1Char('\n') + markupHint()
                         : tr("Return takes it over, Esc forgets it"));
  setLanguage(words.language);
  m_place = place;
  m_lines = words.lines;
  QFont letters = font();
  letters.setPointSizeF(std::max(8.0, double(words.points)));
  setFont(letters);
  setPlainText(words.text);
  selectAll();
  fit();
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
}

void LabelEditor::fit() {
  constexpr int least = 140;
  constexpr int edge = 4;
  int width = least;
  const QStringList lines = toPlainText().split(QLatin1Char('\n'));
  for (const QString& line : lines)
    width = std::max(width, fontMetrics().horizontalAdvance(line) + 28 + languageWidth());
  const int air = 2 * frameWidth() + int(std::ceil(2.0 * document()->documentMargin())) + 2;
  const QSize room = parentWidget()->size() - QSize(2 * edge, 2 * edge);
  QRect box(QPoint(), QSize(width, int(lines.size()) * fontMetrics().lineSpacing() + air));
  box.setSize(box.size().boundedTo(room));
  box.moveLeft(m_place.x());
  box.moveTop(m_place.y() - box.height() / 2);
  box.moveLeft(std::clamp(box.left(), edge, edge + room.width() - box.width()));
  box.moveTop(std::clamp(box.top(), edge, edge + room.height() - box.height()));
  setGeometry(box);
}

void LabelEditor::finish() {
  if (!isOpen())
    return;
  hide();
  const QString text = toPlainText();
  emit accepted(m_lines ? text.trimmed() : text.simplified());
}

void LabelEditor::cancel() {
  if (!isOpen())
    return;
  hide();
  emit cancelled();
}

void LabelEditor::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (event->key() == Qt::Key_Escape) {
    cancel();
    parentWidget()->setFocus(Qt::OtherFocusReason);
  } else if (enter && m_lines && event->modifiers().testFlag(Qt::ShiftModifier)) {
    insertPlainText(QStringLiteral("\n"));
  } else if (enter) {
    finish();
    parentWidget()->setFocus(Qt::OtherFocusReason);
  } else {
    LabelField::keyPressEvent(event);
  }
}

void LabelEditor::focusOutEvent(QFocusEvent* event) {
  LabelField::focusOutEvent(event);
  // Opening its own menu, or another window in front of this one, does not count as leaving it.
  if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason)
    finish();
}

}  // namespace sline::widgets

#include "moc_label_editor.cpp"
