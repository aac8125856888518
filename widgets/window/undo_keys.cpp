// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/undo_keys.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

#include "widgets/shell/window_actions.h"
#include "widgets/window/number_line.h"

namespace sline::widgets {

namespace {

bool takesBack(const QTextDocument& text) {
  return text.isUndoAvailable() || text.isRedoAvailable();
}

/// Tells whether a text is being typed that the field can take back by itself.
bool isTyping(const QWidget& widget) {
  if (widget.property(ownUndo).toBool())
    return true;
  if (qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget)) {
    const QLineEdit* line = lineOf(widget);
    return line && line->isModified() && isTyping(*line);
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget))
    return !line->isReadOnly() && (line->isUndoAvailable() || line->isRedoAvailable());
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget))
    return !text->isReadOnly() && takesBack(*text->document());
  const auto* text = qobject_cast<const QTextEdit*>(&widget);
  return text && !text->isReadOnly() && takesBack(*text->document());
}

/// Tells whether the widget holds text, and so would take the keys for itself. What else takes them
/// has its reasons, as a presentation has, in which nothing is edited.
bool holdsText(const QWidget& widget) {
  return qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QPlainTextEdit*>(&widget) ||
         qobject_cast<const QTextEdit*>(&widget);
}

/// Returns the box that a line belongs to, or else the widget itself.
const QWidget& field(const QWidget& widget) {
  const QWidget* around = widget.parentWidget();
  return qobject_cast<const QAbstractSpinBox*>(around) || qobject_cast<const QComboBox*>(around)
             ? *around
             : widget;
}

/// A number that was entered is no longer typed, even if it reads as before.
void endTyping(QWidget& widget, const QEvent& event) {
  const bool entered = event.type() == QEvent::KeyPress &&
                       (static_cast<const QKeyEvent&>(event).key() == Qt::Key_Return ||
                        static_cast<const QKeyEvent&>(event).key() == Qt::Key_Enter);
  if (!qobject_cast<QAbstractSpinBox*>(&widget) || !(entered || event.type() == QEvent::FocusOut))
    return;
  if (QLineEdit* line = lineOf(widget))
    line->setModified(false);
}

}  // namespace

UndoKeys::UndoKeys(QWidget& window, const WindowActions& actions)
    : QObject(&window), m_window(window), m_actions(actions) {
  qApp->installEventFilter(this);
}

QAction* UndoKeys::actionOf(QEvent& event) const {
  const auto& key = static_cast<QKeyEvent&>(event);
  for (const char* id : {"undo", "redo"}) {
    QAction& action = m_actions[QLatin1String(id)];
    if (action.shortcuts().contains(QKeySequence(key.keyCombination())))
      return &action;
  }
  return nullptr;
}

bool UndoKeys::eventFilter(QObject* watched, QEvent* event) {
  if (!watched->isWidgetType())
    return false;
  auto& widget = static_cast<QWidget&>(*watched);
  endTyping(widget, *event);
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
    return false;
  QAction* action = actionOf(*event);
  if (!action || isTyping(field(widget)))
    return false;
  if (event->type() == QEvent::ShortcutOverride) {
    if (!holdsText(widget))
      return false;
    event->ignore();
    return true;
  }
  // A window that waits for an answer, and one that lies beneath it, leave the scene alone.
  if (widget.window() == &m_window || QApplication::activeModalWidget() ||
      QApplication::activePopupWidget())
    return false;
  action->trigger();
  return true;
}

}  // namespace sline::widgets

#include "moc_undo_keys.cpp"
