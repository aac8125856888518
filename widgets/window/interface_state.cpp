// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/interface_state.h"

#include <QAbstractScrollArea>
#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>

namespace sline::widgets {

namespace {

struct Opener {
  const char* window;
  const char* action;
};
constexpr Opener openers[] = {{"preferencesDialog", "preferences"},
                              {"helpWindow", "help"},
                              {"controlsDialog", "controls"},
                              {"exportDialog", "export"}};

/// Tells whether only the box knows its text; a number's box shows the document's.
bool keepsItsText(const QLineEdit& box) {
  return !box.objectName().isEmpty() && !box.objectName().startsWith(QLatin1String("qt_"));
}

}  // namespace

InterfaceState::InterfaceState(const QMainWindow& window) : m_places(window.saveState()) {
  for (const QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    for (const QLineEdit* box : dock->findChildren<QLineEdit*>())
      if (keepsItsText(*box))
        m_texts[box->objectName()] = box->text();
    for (const QAbstractScrollArea* area : dock->findChildren<QAbstractScrollArea*>())
      m_scrolled[area->objectName()] = {area->horizontalScrollBar()->value(),
                                        area->verticalScrollBar()->value()};
  }
  if (window.focusWidget())
    m_focus = window.focusWidget()->objectName();
  for (const Opener& opener : openers)
    if (const auto* opened = window.findChild<QWidget*>(QLatin1String(opener.window)))
      remember(*opened, opener.action);
}

void InterfaceState::remember(const QWidget& opened, const char* action) {
  Opened memory{.action = QLatin1String(action),
                .name = opened.objectName(),
                .place = opened.geometry(),
                .focus = {}};
  if (const auto* pages = opened.findChild<QTabWidget*>())
    memory.page = pages->currentIndex();
  else if (const auto* list = opened.findChild<QListWidget*>())
    memory.page = list->currentRow();
  if (opened.focusWidget())
    memory.focus = opened.focusWidget()->objectName();
  m_opened.push_back(memory);
}

void InterfaceState::restore(QMainWindow& window) const {
  window.restoreState(m_places);
  for (const auto& [name, text] : m_texts)
    if (auto* box = window.findChild<QLineEdit*>(name); box && box->text() != text)
      box->setText(text);
  for (const auto& [name, place] : m_scrolled)
    if (const auto* area = window.findChild<QAbstractScrollArea*>(name)) {
      area->horizontalScrollBar()->setValue(place.x());
      area->verticalScrollBar()->setValue(place.y());
    }
  auto* focus = m_focus.isEmpty() ? nullptr : window.findChild<QWidget*>(m_focus);
  // Keys go nowhere without a widget that has the keyboard; one without a name is not found again.
  if (!focus)
    focus = window.findChild<QWidget*>(QStringLiteral("viewport"));
  if (focus)
    focus->setFocus();
  for (const Opened& opened : m_opened)
    reopen(window, opened);
}

void InterfaceState::reopen(QMainWindow& window, const Opened& opened) const {
  auto* action = window.findChild<QAction*>(opened.action);
  if (!action)
    return;
  action->trigger();
  auto* again = window.findChild<QWidget*>(opened.name);
  if (!again)
    return;
  again->setGeometry(opened.place);
  if (auto* pages = again->findChild<QTabWidget*>())
    pages->setCurrentIndex(opened.page);
  else if (auto* list = again->findChild<QListWidget*>())
    list->setCurrentRow(opened.page);
  auto* focus = opened.focus.isEmpty() ? nullptr : again->findChild<QWidget*>(opened.focus);
  if (focus)
    focus->setFocus();
}

void clearControls(QMainWindow& window) {
  const auto clear = [](const auto& widgets) {
    for (QWidget* widget : widgets)
      delete widget;
  };
  for (const Opener& opener : openers)
    delete window.findChild<QWidget*>(QLatin1String(opener.window));
  clear(window.findChildren<QDockWidget*>(Qt::FindDirectChildrenOnly));
  clear(window.findChildren<QToolBar*>(Qt::FindDirectChildrenOnly));
  clear(window.findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
  window.setMenuBar(new QMenuBar);
  window.setStatusBar(new QStatusBar);
}

}  // namespace sline::widgets
