// SPDX-License-Identifier: Apache-2.0
// Finds out where the keyboard gets in a window.
#pragma once

#include <QList>
#include <QSet>

class QWidget;

namespace sline::test {

/// Returns the visible widgets below the root that a hand can do something with; parts that Qt
/// makes of them, and bars of scroll areas, which keys move from within, are not among them.
QList<QWidget*> actingWidgets(QWidget& root);

/// Returns the widgets reached by the Tab key, from where the focus is until it is there again.
QSet<QWidget*> reachedByTab(QWidget& root);

/// Tells whether Tab reaches the pressed one of a group of buttons; arrow keys reach the others.
bool besideReached(QWidget* widget, const QSet<QWidget*>& reached);

}  // namespace sline::test
