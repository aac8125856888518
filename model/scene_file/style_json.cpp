// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/style_json.h"

#include "model/base/colour_text.h"
#include "model/scene/style_fields.h"

namespace sline::model {

namespace {

using Ordered = nlohmann::ordered_json;

float numberWithin(const JsonValue& value, const Limits<float>& limits) {
  const float number = value.number();
  if (limits.contain(number))
    return number;
  value.fail("a number from " + std::to_string(int(limits.low)) + " to " +
             std::to_string(int(limits.high)) + " is expected here");
  return limits.low;
}

template <class Field>
std::optional<typename Field::Value> fieldFrom(JsonObject& object, const Field& field, bool newer) {
  using Value = typename Field::Value;
  if constexpr (std::is_enum_v<Value>) {
    const auto index = object.takeChoice(field.key, namesOf(Value()), newer);
    return index ? std::optional(Value(*index)) : std::nullopt;
  } else {
    const std::optional<JsonValue> value = object.take(field.key);
    if (!value)
      return std::nullopt;
    if constexpr (std::same_as<Value, Colour>)
      return value->colour();
    else if constexpr (std::same_as<Value, bool>)
      return value->flag();
    else if constexpr (std::same_as<Value, float>)
      return numberWithin(*value, field.limits());
    else
      return Value::clamped(numberWithin(*value, field.limits()));
  }
}

Ordered fieldJson(const Colour& colour) {
  return colourText(colour);
}
Ordered fieldJson(bool flag) {
  return flag;
}
Ordered fieldJson(float number) {
  return jsonNumber(number);
}
template <class Value>
Ordered fieldJson(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return namesOf(value)[std::size_t(value)];
  else
    return jsonNumber(value.value());
}
}  // namespace

Style styleFrom(JsonObject& object, bool newer) {
  Style style;
  forEachStyleField([&](const auto& field) { style.*field.own = fieldFrom(object, field, newer); });
  return style;
}

Ordered styleJson(const Style& style) {
  Ordered json = Ordered::object();
  forEachStyleField([&](const auto& field) {
    if (const auto& own = style.*field.own)
      json[std::string(field.key)] = fieldJson(*own);
  });
  return json;
}

}  // namespace sline::model
