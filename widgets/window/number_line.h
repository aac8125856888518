// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>

namespace sline::widgets {

/// Returns the line in which a box is typed into; null where it has none. The boxes themselves keep
/// theirs protected.
inline QLineEdit* lineOf(const QWidget& box) {
  return box.findChild<QLineEdit*>(QString(), Qt::FindDirectChildrenOnly);
}

}  // namespace sline::widgets
