// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Numbers the values in a volume in the order in which they occur, and notices where they are no
/// labels.
class LabelCodes {
 public:
  LabelCodes() : m_small(smallValues, 0) {}

  /// Returns the code of a value, 0 for background. A value that is no label becomes 0 as well, and
  /// `refusal` says so.
  template <class T>
  std::uint16_t operator()(T value) {
    const std::uint16_t code = codeOf(value);
    m_changes += code != m_last;
    m_last = code;
    return code;
  }

  /// Returns what speaks against labels, given how many voxels are not background; empty where
  /// nothing does.
  std::string refusal(std::size_t taken) const;
  /// Tells whether the values are no labels, as soon as that is certain.
  bool refused() const { return m_fractions || m_secondNegative || m_values.size() > mostValues; }

  /// Returns labels by ascending value; codes in `voxels` are changed to match.
  std::vector<Label> sorted(std::vector<std::uint16_t>& voxels) const;

 private:
  static constexpr std::size_t smallValues = 65536;
  static constexpr std::size_t mostValues = 4096;

  template <class T>
  std::uint16_t codeOf(T value) {
    if constexpr (std::is_floating_point_v<T>) {
      if (std::isnan(value))
        return 0;
      if (value != std::floor(value) || std::abs(value) > T(9e15)) {
        m_fractions = true;
        return 0;
      }
    }
    return of(std::int64_t(value));
  }

  std::uint16_t of(std::int64_t value);

  std::vector<std::uint16_t> m_small;
  std::unordered_map<std::int64_t, std::uint16_t> m_large;
  std::vector<std::int64_t> m_values;  ///< value of codes 1, 2, …
  std::uint64_t m_changes = 0;         ///< how often a voxel's label differed from the one before
  std::uint16_t m_last = 0;
  std::int64_t m_negative = 0;
  bool m_secondNegative = false;
  bool m_fractions = false;
};

}  // namespace sline::model
