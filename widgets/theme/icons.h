// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QIcon>

namespace sline::widgets {

/// Returns the line drawing of resources/icons with that file name, without ".svg": in the text's
/// colour of whatever theme it is drawn in, sharp at any size. Null where there is no such drawing.
QIcon lineIcon(const QString& name);

}  // namespace sline::widgets
