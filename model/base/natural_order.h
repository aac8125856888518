// SPDX-License-Identifier: Apache-2.0
// Orders names as people do: "rib 7" stands before "rib 10".
#pragma once

#include <filesystem>
#include <string_view>

namespace sline {

/// Compares runs of digits by their value and letters of ASCII without regard to case; where that
/// leaves two texts equal, their bytes decide, so that the order is total.
bool naturallyBefore(std::string_view a, std::string_view b);

/// Compares paths in this order, folder by folder.
bool pathNaturallyBefore(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace sline
