// SPDX-License-Identifier: Apache-2.0
// Fields of the order as values of controls.
#pragma once

#include <type_traits>

#include "widgets/export/export_rows.h"

namespace sline::widgets {

template <class T>
QVariant variantOf(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return int(value);
  else if constexpr (std::is_same_v<T, float>)
    return double(value);
  else if constexpr (std::is_same_v<T, std::string>)
    return QString::fromStdString(value);
  else
    return value;
}

template <class T>
T valueOf(const QVariant& value) {
  if constexpr (std::is_enum_v<T>)
    return T(value.toInt());
  else if constexpr (std::is_same_v<T, std::string>)
    return value.toString().toStdString();
  else
    return value.value<T>();
}

/// Binds the row to the field of the order that `field` names: `[](auto& o) -> auto& { … }`.
template <class Field>
ExportRow bound(ExportRow row, Field field) {
  row.read = [field](const render::ExportOrder& order) { return variantOf(field(order)); };
  row.write = [field](render::ExportOrder& order, const QVariant& value) {
    auto& target = field(order);
    target = valueOf<std::decay_t<decltype(target)>>(value);
  };
  return row;
}

}  // namespace sline::widgets
