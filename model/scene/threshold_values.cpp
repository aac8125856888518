// SPDX-License-Identifier: Apache-2.0
#include "model/scene/threshold_values.h"

#include <algorithm>
#include <cmath>

#include "model/base/letters.h"

namespace sline::model {

namespace {

bool comesBefore(const ThresholdValue& value, std::string_view name) {
  return value.name < name;
}

}  // namespace

std::optional<float> ThresholdValues::of(std::string_view name) const {
  const auto found = std::lower_bound(m_values.begin(), m_values.end(), name, comesBefore);
  return found != m_values.end() && found->name == name ? std::optional(found->value)
                                                        : std::nullopt;
}

void ThresholdValues::set(std::string_view name, float value) {
  const auto place = std::lower_bound(m_values.begin(), m_values.end(), name, comesBefore);
  if (place != m_values.end() && place->name == name)
    place->value = value;
  else
    m_values.insert(place, {std::string(name), value});
}

void ThresholdValues::reset(std::string_view name) {
  std::erase_if(m_values, [name](const ThresholdValue& value) { return value.name == name; });
}

std::optional<std::string_view> thresholdFault(std::string_view name, float value) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return isLower(c) || isDigit(c) || c == '_' || c == '.';
  });
  if (name.empty() || name.size() > longestThresholdName || !plain)
    return "a threshold's name has 1 to 64 small letters, digits, '_' and '.'";
  if (!thresholdValueLimits.contain(value))
    return "a threshold lies from 0 to 1000000";
  return std::nullopt;
}

ThresholdValues between(const ThresholdValues& from, const ThresholdValues& to, float part) {
  ThresholdValues values = part < 0.5f ? from : to;
  for (const ThresholdValue& value : from.all())
    if (const std::optional<float> other = to.of(value.name))
      values.set(value.name, std::lerp(value.value, *other, part));
  return values;
}

}  // namespace sline::model
