// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>

namespace sline::model {

/// Names a node for as long as the scene lives, through every edit and through undo.
struct NodeId {
  std::uint64_t value = 0;  ///< 0 is the invisible root
  auto operator<=>(const NodeId&) const = default;
};
inline constexpr NodeId rootId{};

}  // namespace sline::model
