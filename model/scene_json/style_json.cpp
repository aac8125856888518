// SPDX-License-Identifier: Apache-2.0
#include "model/scene_json/style_json.h"

#include "model/base/colour_text.h"
#include "model/scene/gamma_map.h"
#include "model/scene/style_fields.h"
#include "model/scene/threshold_values.h"

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

/// Returns a curve written as a list of pairs.
std::vector<GammaPoint> curveFrom(const JsonValue& list) {
  std::vector<GammaPoint> curve;
  list.forEach([&](const JsonValue& pair) {
    const std::array<float, 2> point = pair.numbers<2>();
    if (curve.size() >= mostGammaPoints)
      return list.fail("a curve has 2 to 8 points");
    curve.push_back({point[0], point[1]});
  });
  return curve;
}

std::optional<GammaMap> gammaMapFrom(JsonObject& style, std::string_view key, bool newer) {
  const std::optional<JsonValue> value = style.take(key);
  if (!value)
    return std::nullopt;
  JsonObject object(*value);
  GammaMap map;
  const FaultWatch watch(value->fault());
  const auto scalar = object.takeChoice("scalar", gammaScalarNames, newer);
  if (!scalar && !newer)
    value->fail("a scalar is expected here");
  if (!scalar) {
    // What a newer program means stays as it stands.
    if (newer)
      style.giveBack(key, value->json());
    return std::nullopt;
  }
  map.scalar = GammaScalar(*scalar);
  if (const auto list = object.take("targets"))
    list->forEach([&](const JsonValue& id) {
      if (map.targets.size() >= mostGammaTargets)
        return list->fail("there are more than 1000 targets");
      map.targets.push_back({std::uint64_t(id.whole(1, std::int64_t(1) << 53))});
    });
  if (const auto place = object.take("place_mm"))
    map.place = place->point();
  if (const auto list = object.take("curve"))
    map.curve = curveFrom(*list);
  if (const auto fault = gammaMapFault(map); fault && watch.clean())
    value->fail(*fault);
  if (!watch.clean())
    return std::nullopt;
  style.giveBack(key, object.rest());
  return map;
}

ThresholdValues thresholdsFrom(const JsonValue& object) {
  ThresholdValues values;
  if (!object.json().is_object() || object.json().size() > mostThresholdValues) {
    object.fail("an object of at most 64 numbers is expected here");
    return values;
  }
  for (const auto& [name, number] : object.json().items()) {
    const JsonValue value(number, object, name);
    const FaultWatch watch(value.fault());
    const float threshold = value.number();
    if (const auto fault = thresholdFault(name, threshold); fault && watch.clean())
      value.fail(*fault);
    if (watch.clean())
      values.set(name, threshold);
  }
  return values;
}

template <class Field>
std::optional<typename Field::Value> fieldFrom(JsonObject& object, const Field& field, bool newer) {
  using Value = typename Field::Value;
  if constexpr (std::is_enum_v<Value>) {
    const auto index = object.takeChoice(field.key, namesOf(Value()), newer);
    return index ? std::optional(Value(*index)) : std::nullopt;
  } else if constexpr (std::same_as<Value, GammaMap>) {
    return gammaMapFrom(object, field.key, newer);
  } else {
    const std::optional<JsonValue> value = object.take(field.key);
    if (!value)
      return std::nullopt;
    if constexpr (std::same_as<Value, ThresholdValues>)
      return thresholdsFrom(*value);
    else
      return sound(*value, [&field](const JsonValue& own) {
        if constexpr (std::same_as<Value, Colour>)
          return own.colour();
        else if constexpr (std::same_as<Value, bool>)
          return own.flag();
        else if constexpr (std::same_as<Value, float>)
          return numberWithin(own, field.limits());
        else
          return Value::clamped(numberWithin(own, field.limits()));
      });
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
Ordered fieldJson(const GammaMap& map) {
  Ordered json = {{"scalar", gammaScalarNames[std::size_t(map.scalar)]}};
  for (const NodeId target : map.targets)
    json["targets"].push_back(target.value);
  if (map.place)
    json["place_mm"] = jsonPoint(*map.place);
  for (const GammaPoint& point : map.curve)
    json["curve"].push_back({jsonNumber(point.scalar), jsonNumber(point.offset)});
  return json;
}
Ordered fieldJson(const ThresholdValues& values) {
  Ordered json = Ordered::object();
  for (const ThresholdValue& value : values.all())
    json[value.name] = jsonNumber(value.value);
  return json;
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
