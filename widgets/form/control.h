// SPDX-License-Identifier: Apache-2.0
// Makes controls from fields, in one way for all dialogs.
#pragma once

#include <functional>

#include "widgets/form/field.h"

class QWidget;

namespace sline::widgets {

/// Makes the field's control: a check box with the field's text, a combo box, a spin box or a text
/// field, named and described as the field is. `take` gets each value that the user enters.
QWidget* makeControl(const Field& field, const std::function<void(const QVariant&)>& take,
                     QWidget* parent = nullptr);

/// Shows the value in a control that was made of such a field, without calling `take`; shows no
/// entry where no choice has the value.
void showValue(QWidget& control, const FieldKind& kind, const QVariant& value);

}  // namespace sline::widgets
