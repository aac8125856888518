// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/label_codes.h"

#include <algorithm>
#include <numeric>

namespace sline::model {

std::uint16_t LabelCodes::of(std::int64_t value) {
  if (value == 0)
    return 0;
  if (value < 0) {
    // Some programs mark voxels outside their field of view with one value below zero.
    m_secondNegative = m_secondNegative || (m_negative != 0 && m_negative != value);
    m_negative = value;
    return 0;
  }
  if (m_values.size() > mostValues)
    return 0;
  std::uint16_t& code =
      value < std::int64_t(smallValues) ? m_small[std::size_t(value)] : m_large[value];
  if (code == 0) {
    m_values.push_back(value);
    code = std::uint16_t(m_values.size());
  }
  return code;
}

std::string LabelCodes::refusal(std::size_t taken) const {
  constexpr std::size_t manyValues = 64;
  if (m_fractions)
    return "its voxels are not whole numbers";
  if (m_secondNegative)
    return "it holds different values below zero";
  if (m_values.size() > mostValues)
    return "it holds more than " + std::to_string(mostValues) + " different values";
  // Structures are larger than a voxel: along a row, few voxels differ from the one before.
  if (m_values.size() >= manyValues && 4 * m_changes > 3 * taken)
    return "it holds " + std::to_string(m_values.size()) +
           " different values that change from voxel to voxel";
  return {};
}

std::vector<Label> LabelCodes::sorted(std::vector<std::uint16_t>& voxels) const {
  std::vector<std::size_t> order(m_values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [this](std::size_t a, std::size_t b) { return m_values[a] < m_values[b]; });
  std::vector<Label> labels(order.size());
  std::vector<std::uint16_t> now(order.size() + 1, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    labels[i].value = m_values[order[i]];
    now[order[i] + 1] = std::uint16_t(i + 1);
  }
  if (!std::is_sorted(now.begin(), now.end()))
    for (std::uint16_t& voxel : voxels)
      voxel = now[voxel];
  return labels;
}

}  // namespace sline::model
