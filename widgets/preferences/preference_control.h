// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/form/control.h"
#include "widgets/preferences/preferences.h"

namespace sline::widgets {

/// Makes a control that sets the preference and follows it. Its objectName is the id, its
/// accessible name the preference's text.
QWidget* makePreferenceControl(Preferences& preferences, const QString& id);

}  // namespace sline::widgets
