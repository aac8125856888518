// SPDX-License-Identifier: Apache-2.0
// Operates the list of structures in the window, and says what it shows.
#pragma once

#include <QKeySequence>
#include <QLineEdit>
#include <QPoint>
#include <QString>

#include "tests/gui/window_fixture.h"

namespace sline::test {

model::NodeId id(WindowFixture& f, const QString& name);

widgets::NodeIds ids(WindowFixture& f, const QString& names);

QPoint cell(WindowFixture& f, const QString& name, int column);

void click(WindowFixture& f, const QString& name, int column, Qt::KeyboardModifiers keys = {},
           Qt::MouseButton button = Qt::LeftButton);

QString shown(WindowFixture& f);

void press(WindowFixture& f, const QKeySequence& keys);

QLineEdit* editor(WindowFixture& f);

}  // namespace sline::test
