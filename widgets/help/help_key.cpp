// SPDX-License-Identifier: Apache-2.0
#include "widgets/help/help_key.h"

#include <QCoreApplication>
#include <QDialog>
#include <QKeyEvent>

#include "widgets/help/help_pages.h"
#include "widgets/help/help_window.h"

namespace sline::widgets {

HelpKey::HelpKey(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

void HelpKey::showHelp(QWidget& about) {
  // The help is a child of the window that it explains, because a dialog keeps the keyboard from
  // all other windows.
  QWidget* window = about.window();
  auto* help = window->findChild<HelpWindow*>(QString(), Qt::FindDirectChildrenOnly);
  if (!help)
    help = new HelpWindow(window);
  help->showPage(helpPageOf(&about));
  help->show();
  help->raise();
  help->activateWindow();
}

bool HelpKey::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || !watched->isWidgetType())
    return false;
  const auto* key = static_cast<QKeyEvent*>(event);
  auto* widget = static_cast<QWidget*>(watched);
  if (key->key() != Qt::Key_F1 || key->modifiers() != Qt::NoModifier ||
      !qobject_cast<QDialog*>(widget->window()))
    return false;
  showHelp(*widget);
  return true;
}

}  // namespace sline::widgets

#include "moc_help_key.cpp"
