// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QStringList>

#include "model/scene/scene.h"

namespace sline::widgets {

/// What is open: a scene and the name it goes by. A value, so that undo is the previous one.
struct Document {
  model::Scene scene;
  QString title;
  /// One for each opening, so that whoever shows the document sees where another begins; 0: nothing
  /// was opened yet.
  int opening = 0;
  bool operator==(const Document&) const = default;
};

/// A scene on its way in, and what its reader had to leave out or mend.
struct Loaded {
  model::Scene scene;
  QString title;
  QStringList remarks;
};

}  // namespace sline::widgets
