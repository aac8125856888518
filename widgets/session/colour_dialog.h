// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>

#include "widgets/session/display_names.h"

class QColorDialog;
class QWidget;

namespace sline::widgets {

/// Makes the dialog in which every colour is chosen: beside its own colours stand those that
/// structures have by convention, by name. It deletes itself when it is closed.
QColorDialog* makeColourDialog(const DisplayNames& names, const QColor& now, QWidget* parent);

}  // namespace sline::widgets
