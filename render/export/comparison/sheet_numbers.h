// SPDX-License-Identifier: Apache-2.0
// Writes numbers for sheets: in few characters, the same in every locale.
#pragma once

#include <string>

namespace sline::render {

/// Returns the number with as many digits as it needs: "0.15", "2".
std::string shortNumber(float value);
/// Returns three digits: "0.123", "12.3", "123".
std::string threeDigits(double value);
/// Returns a count in groups of three: "67 158".
std::string grouped(std::size_t count);

}  // namespace sline::render
