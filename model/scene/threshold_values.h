// SPDX-License-Identifier: Apache-2.0
// Holds the thresholds with which a structure's lines are found, where they are not the usual ones
// of its technique. Which thresholds there are, and what they mean,
// render/lines/techniques/technique_list.h says; a name that nobody knows changes nothing and is
// kept.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/units.h"

namespace sline::model {

struct ThresholdValue {
  std::string name;  ///< "laplacian.slope"
  float value = 0.0f;
  bool operator==(const ThresholdValue&) const = default;
};

inline constexpr std::size_t mostThresholdValues = 64;
inline constexpr std::size_t longestThresholdName = 64;
inline constexpr Limits<float> thresholdValueLimits{0.0f, 1e6f};

class ThresholdValues {
 public:
  ThresholdValues() = default;
  ThresholdValues(std::initializer_list<ThresholdValue> values) {
    for (const ThresholdValue& value : values)
      set(value.name, value.value);
  }
  /// Returns the value of that name, if one is set.
  std::optional<float> of(std::string_view name) const;
  void set(std::string_view name, float value);
  /// Makes the value the usual one again.
  void reset(std::string_view name);
  /// Returns the values in the order of their names.
  const std::vector<ThresholdValue>& all() const { return m_values; }
  bool empty() const { return m_values.empty(); }
  bool operator==(const ThresholdValues&) const = default;

 private:
  std::vector<ThresholdValue> m_values;
};

/// Returns what makes a name or a value unusable, for an error message.
std::optional<std::string_view> thresholdFault(std::string_view name, float value);

/// Returns values part of the way from one to another, 0 … 1. A value that one of them lacks is
/// that of the nearer end.
ThresholdValues between(const ThresholdValues& from, const ThresholdValues& to, float part);

}  // namespace sline::model
