// SPDX-License-Identifier: Apache-2.0
// Says how it is known where left and right are and how long a unit is, and so what may be printed
// as a fact.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace sline::model {

/// Ranks what tells a direction or a length, the surest first.
enum class Evidence : std::uint8_t {
  known,     ///< the file, its format or the scene around it says so, or the program made it
  settled,   ///< a person has said so
  voted,     ///< names or places clearly say so
  assumed,   ///< nothing clearly says so
  conflict,  ///< names, places or sizes contradict what the file says
};
inline constexpr std::array<std::string_view, 5> evidenceNames{"known", "settled", "voted",
                                                               "assumed", "conflict"};
/// Returns the kind of that name, or nothing.
std::optional<Evidence> evidenceNamed(std::string_view name);

/// Tells whether it may be printed without a question mark.
constexpr bool isSure(Evidence evidence) {
  return evidence < Evidence::assumed;
}

/// Holds how it is known which way leads to the left, which to the back and which to the head.
struct SideEvidence {
  Evidence sides = Evidence::known;
  Evidence front = Evidence::known;
  Evidence up = Evidence::known;
  bool isSure() const { return model::isSure(sides) && model::isSure(front) && model::isSure(up); }
  bool operator==(const SideEvidence&) const = default;
};

}  // namespace sline::model
