// SPDX-License-Identifier: Apache-2.0
// Moves a number of several looks at once, so that their differences stay.
#pragma once

#include <span>

#include "model/edit/edited.h"
#include "model/scene/style_fields.h"

namespace sline::model {

/// Describes a number of a look to the edits here.
struct LookNumber {
  float (*value)(const ResolvedStyle&) = nullptr;
  std::optional<float> (*own)(const Style&) = nullptr;
  Style (*look)(float) = nullptr;  ///< a look that answers this field alone
  Limits<float> limits;
};

inline float plainNumber(float value) {
  return value;
}
template <class T>
float plainNumber(const T& value) {
  return value.value();
}

/// Returns the description of a field whose value is a float or a `Bounded`.
template <const auto& Field>
LookNumber lookNumber() {
  using Value = typename std::remove_cvref_t<decltype(Field)>::Value;
  return {[](const ResolvedStyle& style) { return plainNumber(style.*Field.resolved); },
          [](const Style& style) {
            const auto& own = style.*Field.own;
            return own ? std::optional<float>(plainNumber(*own)) : std::nullopt;
          },
          [](float value) {
            Style style;
            if constexpr (std::is_same_v<Value, float>)
              style.*Field.own = value;
            else
              style.*Field.own = Value::clamped(value);
            return style;
          },
          Field.limits()};
}

/// Returns how far of `by` the number can move in all structures at or below the nodes before the
/// first of them reaches a limit. Only those count that are shown, or all where none is; locked
/// ones do not move and never count.
float roomToMove(const Scene& scene, std::span<const NodeId> ids, const LookNumber& number,
                 float by);

/// Moves the number from what it is in the nodes, `from`, to `to`. Where structures at or below
/// them differ, each moves by the same amount, as far as `roomToMove` allows, and who inherits goes
/// on inheriting; where they agree this is `withLook`.
Edited withLookMoved(const Scene& scene, std::span<const NodeId> ids, const LookNumber& number,
                     float from, float to);

}  // namespace sline::model
