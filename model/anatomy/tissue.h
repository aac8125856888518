// SPDX-License-Identifier: Apache-2.0
// Says what a structure is made of, as far as that decides how it is drawn around others.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace sline::model {

enum class Tissue { unknown, lesion, organ, vessel, nerve, bone, joint, muscle, skin };

/// The names of the tissues in resources/anatomy/systems.tsv, in the order of the values.
inline constexpr std::array<std::string_view, 9> tissueNames{
    "unknown", "lesion", "organ", "vessel", "nerve", "bone", "joint", "muscle", "skin"};

inline std::optional<Tissue> tissueNamed(std::string_view name) {
  const auto* const found = std::find(tissueNames.begin(), tissueNames.end(), name);
  return found == tissueNames.end() ? std::nullopt
                                    : std::optional(Tissue(found - tissueNames.begin()));
}

}  // namespace sline::model
