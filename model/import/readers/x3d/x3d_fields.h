// SPDX-License-Identifier: Apache-2.0
// Reads the fields of nodes as numbers and transforms.
#pragma once

#include <algorithm>
#include <array>
#include <glm/mat4x4.hpp>
#include <string_view>
#include <vector>

#include "model/import/readers/x3d/x3d_document.h"

namespace sline::model {

/// Returns all numbers of a field, separated by blanks, commas and comments; they end at text that
/// is none.
std::vector<double> numbersIn(std::string_view field);

/// Returns the field as `n` numbers, else the default that applies when it is absent.
template <std::size_t n>
std::array<double, n> fixedNumbers(const X3dNode& node, std::string_view key,
                                   const std::array<double, n>& otherwise) {
  const std::vector<double> numbers = numbersIn(node.field(key));
  std::array<double, n> values = otherwise;
  if (numbers.size() == n)
    std::copy(numbers.begin(), numbers.end(), values.begin());
  return values;
}

/// Returns the transform by ISO/IEC 19775-1 §10.4.4: translation · centre · rotation · scale in its
/// own axes · −centre.
glm::dmat4 transformOf(const X3dNode& node);

}  // namespace sline::model
