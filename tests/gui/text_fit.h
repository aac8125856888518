// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

class QWidget;

namespace sline::test {

/// Returns one line for each visible control below the widget that has too little room for its
/// text. Text that is meant to be cut short, such as names in lists, counts as whole.
QStringList clippedTexts(const QWidget& root);

}  // namespace sline::test
