// SPDX-License-Identifier: Apache-2.0
#include "widgets/annotations/label_field.h"

#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QTextDocumentFragment>
#include <algorithm>

namespace sline::widgets {

namespace {

/// Cleans text from word processors, which end lines in several ways and have characters that are
/// never displayed.
QString cleaned(QString text) {
  text.replace(QLatin1String("\r\n"), QLatin1String("\n"));
  QString clean;
  for (const QChar c : text) {
    const bool ends = c == u'\v' || c == u'\f' || c == u'\r' || c == QChar::LineSeparator ||
                      c == QChar::ParagraphSeparator;
    if (ends)
      clean += u'\n';
    else if (c == u'\n' || c == u'\t' ||
             (c.category() != QChar::Other_Control && c != QChar::ObjectReplacementCharacter))
      clean += c;
  }
  return clean;
}

QString shortcut(QKeySequence::StandardKey key) {
  return QKeySequence(key).toString(QKeySequence::NativeText);
}

}  // namespace

LabelField::LabelField(QWidget* parent) : QPlainTextEdit(parent), m_language(new QLabel(this)) {
  m_language->setObjectName(QStringLiteral("labelLanguage"));
  m_language->setTextFormat(Qt::PlainText);
  m_language->setAttribute(Qt::WA_TransparentForMouseEvents);
  m_language->setEnabled(false);  // it is quieter than the words
  m_language->hide();
}

void LabelField::setLanguage(const QString& name) {
  m_language->setText(name);
  m_language->adjustSize();
  m_language->setVisible(!name.isEmpty());
  setAccessibleDescription(name);
  setViewportMargins(0, 0, languageWidth(), 0);
  placeLanguage();
}

void LabelField::setHint(const QString& hint) {
  if (hint == placeholderText())
    return;
  setPlaceholderText(hint);
  viewport()->update();
}

int LabelField::languageWidth() const {
  constexpr int air = 8;
  return m_language->text().isEmpty() ? 0 : m_language->sizeHint().width() + air;
}

void LabelField::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  placeLanguage();
}

void LabelField::placeLanguage() {
  constexpr int edge = 3;
  const QSize size = m_language->sizeHint();
  m_language->setGeometry(width() - frameWidth() - edge - size.width(),
                          height() - frameWidth() - edge - size.height(), size.width(),
                          size.height());
}

QString LabelField::markupHint() {
  return tr("**bold** (%1), *italic* (%2); lines that begin with “- ” are a list")
             .arg(shortcut(QKeySequence::Bold), shortcut(QKeySequence::Italic)) +
         QLatin1Char('\n') + linkHint();
}

QString LabelField::linkHint() {
  return tr(
      "In presentations and on students' pages [ureter](#structure=left ureter) lights that "
      "structure up, and [from behind](#view=2) goes to a view");
}

std::optional<model::LetterMark> LabelField::markOf(QKeyEvent& key) const {
  if (!m_markup)
    return std::nullopt;
  if (key.matches(QKeySequence::Bold))
    return model::LetterMark::bold;
  return key.matches(QKeySequence::Italic) ? std::optional(model::LetterMark::italic)
                                           : std::nullopt;
}

bool LabelField::event(QEvent* event) {
  // These keys have another meaning elsewhere in the window.
  if (event->type() == QEvent::ShortcutOverride && markOf(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QPlainTextEdit::event(event);
}

void LabelField::keyPressEvent(QKeyEvent* event) {
  if (const auto which = markOf(*event))
    mark(*which);
  else
    QPlainTextEdit::keyPressEvent(event);
}

void LabelField::mark(model::LetterMark mark) {
  const QString text = toPlainText();
  QTextCursor cursor = textCursor();
  const auto bytes = [&text](int position) {
    return std::size_t(text.left(position).toUtf8().size());
  };
  const model::MarkedText made = model::withLetterStyle(
      text.toStdString(), {bytes(cursor.selectionStart()), bytes(cursor.selectionEnd())}, mark);
  const QString now = QString::fromStdString(made.text);
  if (now == text)
    return;
  // Only the part that differs is replaced.
  const auto head = std::mismatch(text.begin(), text.end(), now.begin(), now.end()).first;
  const auto same = int(head - text.begin());
  int tail = 0;
  while (tail < int(std::min(text.size(), now.size())) - same &&
         text[text.size() - 1 - tail] == now[now.size() - 1 - tail])
    ++tail;
  cursor.setPosition(same);
  cursor.setPosition(int(text.size()) - tail, QTextCursor::KeepAnchor);
  cursor.insertText(now.mid(same, now.size() - tail - same));
  const auto position = [&made](std::size_t byte) {
    return int(QString::fromUtf8(made.text.data(), qsizetype(byte)).size());
  };
  cursor.setPosition(position(made.selection.begin));
  cursor.setPosition(position(made.selection.end), QTextCursor::KeepAnchor);
  setTextCursor(cursor);
}

bool LabelField::canInsertFromMimeData(const QMimeData* source) const {
  return QPlainTextEdit::canInsertFromMimeData(source) || source->hasHtml();
}

void LabelField::insertFromMimeData(const QMimeData* source) {
  if (isReadOnly())
    return;
  const QString text = source->hasText()
                           ? source->text()
                           : QTextDocumentFragment::fromHtml(source->html()).toPlainText();
  insertPlainText(cleaned(text));
  ensureCursorVisible();
}

}  // namespace sline::widgets

#include "moc_label_field.cpp"
