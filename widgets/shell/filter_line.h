// SPDX-License-Identifier: Apache-2.0
// Makes the lines in which one types what is looked for in a list.
#pragma once

#include <QString>

class QLineEdit;

namespace sline::widgets {

/// Returns a line of that object name, with a button that clears it. What is typed to find
/// something is no step of the scene: Undo and Redo are the line's own (`ownUndo`).
QLineEdit* makeFilterLine(const QString& id, const QString& accessibleName,
                          const QString& placeholder);

}  // namespace sline::widgets
