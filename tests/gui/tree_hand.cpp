// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/tree_hand.h"

#include <QtTest>
#include <algorithm>

namespace sline::test {

model::NodeId id(WindowFixture& f, const QString& name) {
  const std::vector<model::NodeId> found = f.session.scene().named(name.toStdString());
  if (found.size() != 1)
    qFatal("%zu nodes are named %s", found.size(), qPrintable(name));
  return found.front();
}

widgets::NodeIds ids(WindowFixture& f, const QString& names) {
  widgets::NodeIds found;
  for (const QString& name : names.split(',', Qt::SkipEmptyParts))
    found.push_back(id(f, name));
  std::sort(found.begin(), found.end());
  return found;
}

QPoint cell(WindowFixture& f, const QString& name, int column) {
  return f.tree().cellOf(id(f, name), column).center();
}

void click(WindowFixture& f, const QString& name, int column, Qt::KeyboardModifiers keys,
           Qt::MouseButton button) {
  QTest::mouseClick(f.tree().viewport(), button, keys, cell(f, name, column));
}

QString shown(WindowFixture& f) {
  QStringList names;
  for (const model::NodeId each : f.session.scene().structuresBelow(model::rootId))
    if (f.session.scene().resolve(each).visible)
      names << QString::fromStdString(f.session.scene().find(each)->name);
  return names.join(',');
}

void press(WindowFixture& f, const QKeySequence& keys) {
  f.tree().setFocus();
  QTest::keySequence(&f.tree(), keys);
}

QLineEdit* editor(WindowFixture& f) {
  return f.tree().findChild<QLineEdit*>("nameEditor");
}

}  // namespace sline::test
