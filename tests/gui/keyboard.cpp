// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/keyboard.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QLineEdit>
#include <QtTest>
#include <algorithm>

namespace sline::test {

namespace {

bool acts(const QWidget& widget) {
  return qobject_cast<const QAbstractButton*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
         qobject_cast<const QAbstractItemView*>(&widget) || widget.focusPolicy() != Qt::NoFocus;
}

/// Tells whether it is a part of a control that Qt makes, or a bar of a scroll area, which keys
/// move from within.
bool isPart(const QWidget& widget) {
  for (const QWidget* at = &widget; at; at = at->parentWidget()) {
    if (at->objectName().startsWith(QLatin1String("qt_")))
      return true;
    if (at != &widget && (qobject_cast<const QAbstractSpinBox*>(at) ||
                          qobject_cast<const QComboBox*>(at) || qobject_cast<const QLineEdit*>(at)))
      return true;
  }
  const QString kind = QLatin1String(widget.metaObject()->className());
  return kind == QLatin1String("QScrollBar") || kind == QLatin1String("QHeaderView") ||
         kind == QLatin1String("QTabBar") || kind == QLatin1String("QTabWidget") ||
         kind == QLatin1String("QDockWidgetTitleButton") || kind == QLatin1String("QSizeGrip") ||
         kind == QLatin1String("QSplitterHandle") || kind == QLatin1String("QMenuBar") ||
         kind == QLatin1String("QMenu");
}

}  // namespace

QList<QWidget*> actingWidgets(QWidget& root) {
  QList<QWidget*> found;
  for (QWidget* widget : root.findChildren<QWidget*>())
    if (widget->isVisibleTo(&root) && widget->window() == root.window() && acts(*widget) &&
        !isPart(*widget))
      found << widget;
  return found;
}

QSet<QWidget*> reachedByTab(QWidget& root) {
  QSet<QWidget*> reached;
  for (int i = 0; i < 300 && QApplication::focusWidget(); ++i) {
    QWidget* at = QApplication::focusWidget();
    if (at->window() != root.window() || reached.contains(at))
      break;
    reached << at;
    QTest::keyClick(at, Qt::Key_Tab);
  }
  return reached;
}

bool besideReached(QWidget* widget, const QSet<QWidget*>& reached) {
  const auto* button = qobject_cast<QAbstractButton*>(widget);
  if (!button || !button->group() || !button->group()->exclusive())
    return false;
  const QList<QAbstractButton*> together = button->group()->buttons();
  return std::any_of(together.begin(), together.end(),
                     [&reached](QAbstractButton* each) { return reached.contains(each); });
}

}  // namespace sline::test
