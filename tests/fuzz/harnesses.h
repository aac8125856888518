// SPDX-License-Identifier: Apache-2.0
// Declares each reader of bytes from outside as a function of bytes alone: libFuzzer looks for
// input that breaks one, and an ordinary test replays what it found.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sline::fuzz {

struct Harness {
  std::string_view name;  ///< names its folders of seeds and crashers, and its dictionary
  /// Returns what was wrong with the answer, or an empty text. The input may be refused, but with a
  /// reason.
  std::string (*run)(std::string_view bytes);
};

std::span<const Harness> harnesses();
/// Returns the harness of that name, or null if there is none.
const Harness* harnessNamed(std::string_view name);

}  // namespace sline::fuzz
