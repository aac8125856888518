// SPDX-License-Identifier: Apache-2.0
// What takes bytes from outside, each as a function of bytes alone: libFuzzer looks for input that
// breaks one, and an ordinary test replays what it found.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace sline::fuzz {

struct Harness {
  std::string_view name;  ///< of its folders of seeds and crashers, and of its dictionary
  /// What was wrong with the answer, empty where nothing was. The input may be refused, but with a
  /// reason.
  std::string (*run)(std::string_view bytes);
};

std::span<const Harness> harnesses();
/// Null where there is none of that name.
const Harness* harnessNamed(std::string_view name);

}  // namespace sline::fuzz
