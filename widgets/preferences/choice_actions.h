// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QMenu;

namespace sline::widgets {

class Preferences;

/// Adds an action for each choice of the preference to the menu, named `names`, "-" and the
/// choice's id. The current choice is checked; triggering another sets the preference.
void addChoiceActions(QMenu& menu, Preferences& preferences, const QString& id,
                      const QString& names);

}  // namespace sline::widgets
