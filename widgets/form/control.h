// SPDX-License-Identifier: Apache-2.0
// Controls that are made of fields: one way for all dialogs.
#pragma once

#include <functional>

#include "widgets/form/field.h"

class QWidget;

namespace sline::widgets {

/// Makes the field's control: a check box with the field's text, a combo box, a spin box or a field
/// for text, named and described as the field is. `take` gets each value that a person gives it.
QWidget* makeControl(const Field& field, const std::function<void(const QVariant&)>& take,
                     QWidget* parent = nullptr);

/// Shows the value in a control that was made of such a field, without telling anybody; no entry
/// where no choice has it.
void showValue(QWidget& control, const FieldKind& kind, const QVariant& value);

}  // namespace sline::widgets
