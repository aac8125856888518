// SPDX-License-Identifier: Apache-2.0
#include "widgets/shell/filter_line.h"

#include <QLineEdit>

#include "widgets/shell/window_actions.h"

namespace sline::widgets {

QLineEdit* makeFilterLine(const QString& id, const QString& accessibleName,
                          const QString& placeholder) {
  auto* line = new QLineEdit;
  line->setObjectName(id);
  line->setAccessibleName(accessibleName);
  line->setPlaceholderText(placeholder);
  line->setClearButtonEnabled(true);
  line->setProperty(ownUndo, true);
  return line;
}

}  // namespace sline::widgets
