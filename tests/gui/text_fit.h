// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

class QWidget;

namespace sline::test {

/// Controls below the widget, as far as they are visible, whose text has not all its room: one line
/// for each. What is meant to be cut short, such as names in lists, counts as whole.
QStringList clippedTexts(const QWidget& root);

}  // namespace sline::test
