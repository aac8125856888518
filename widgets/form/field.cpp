// SPDX-License-Identifier: Apache-2.0
#include "widgets/form/field.h"

#include <algorithm>
#include <cmath>

namespace sline::widgets {

namespace {

/// Accepts "true" and "false" as words too, as settings files hold them.
bool allowsValue(const SwitchField&, const QVariant& value) {
  return value.typeId() == QMetaType::Bool || value.toString() == QLatin1String("true") ||
         value.toString() == QLatin1String("false");
}

bool allowsValue(const ChoiceField& kind, const QVariant& value) {
  return std::any_of(kind.choices.begin(), kind.choices.end(),
                     [&value](const Choice& choice) { return choice.id == value.toString(); });
}

bool allowsValue(const NumberField& kind, const QVariant& value) {
  bool isNumber = false;
  const double number = value.toDouble(&isNumber);
  return isNumber && number >= kind.low && number <= kind.high &&
         (kind.decimals > 0 || number == std::round(number));
}

bool allowsValue(const TextField& kind, const QVariant& value) {
  return value.canConvert<QString>() && value.toString().size() <= kind.longest;
}

}  // namespace

bool allows(const FieldKind& kind, const QVariant& value) {
  return value.isValid() &&
         std::visit([&value](const auto& each) { return allowsValue(each, value); }, kind);
}

}  // namespace sline::widgets
