// SPDX-License-Identifier: Apache-2.0
// Provides the window with its panel of labels in front, and helpers that operate it.
#pragma once

#include <QComboBox>
#include <QDockWidget>
#include <QToolButton>
#include <QTreeView>

#include "tests/gui/labels_fixture.h"

namespace sline::test {

struct LabelsPanelFixture : Labels {
  using Labels::Labels;
  void open() {
    control<QDockWidget>("annotationsPanel").raise();
    QCoreApplication::processEvents();
    if (!list().isVisible())
      qFatal("the panel is not there");
  }
  QTreeView& list() { return control<QTreeView>("annotationList"); }
  QModelIndex cell(int row, int column) { return list().model()->index(row, column); }
  QString said(int row, int column) { return cell(row, column).data().toString(); }
  void choose(int row) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, {},
                      list().visualRect(cell(row, 1)).center());
  }
  QPlainTextEdit& words() { return control<QPlainTextEdit>("annotationText"); }
  QComboBox& box(const char* name) { return control<QComboBox>(name); }
  /// Chooses by keys, as a user would.
  void pick(const char* name, int row) {
    QComboBox& there = box(name);
    there.setFocus();
    while (there.currentIndex() > row)
      QTest::keyClick(&there, Qt::Key_Up);
    while (there.currentIndex() < row)
      QTest::keyClick(&there, Qt::Key_Down);
  }
  /// Makes a label where no other one is in the way of the click.
  void makeBeside(model::NodeId on, const QString& text) {
    key(Qt::Key_T);
    click(middleOf(on) + QPoint(0, areaOf(on).height() / 4));
    if (!typing())
      qFatal("no words can be typed");
    QTest::keyClicks(&editor(), text);
    QTest::keyClick(&editor(), Qt::Key_Return);
    key(Qt::Key_Escape);
    if (!settled())
      qFatal("no picture with the label");
  }
  QStringList rowsOf(const char* name) {
    QStringList all;
    for (int i = 0; i < box(name).count(); ++i)
      all << box(name).itemText(i);
    return all;
  }
  void press(const char* name) { QTest::mouseClick(&control<QToolButton>(name), Qt::LeftButton); }
};

}  // namespace sline::test
