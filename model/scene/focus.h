// SPDX-License-Identifier: Apache-2.0
// Says what a scene, or a view of it, has in focus, so that a person finds it again tomorrow. What
// follows for the styles of all others is worked out in model/focus.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/units.h"
#include "model/camera/camera.h"
#include "model/scene/look.h"

namespace sline::model {

/// Says what a structure is to those in focus.
enum class ContextRole {
  target,
  feeder,  ///< a vessel or duct that comes to a target, or the stem from which such a vessel comes
  neighbour,  ///< lies beside a target
  shell,      ///< lies outside, around or before a target, and hides it
  backdrop,   ///< everything else: far off and out of the way
};
inline constexpr std::array<std::string_view, 5> contextRoleNames{"target", "feeder", "neighbour",
                                                                  "shell", "backdrop"};

/// The amount runs from 0 (the focus on empty paper) to 1 (everything clearly there).
using ContextAmount = Bounded<struct ContextAmountTag, 0, 1>;

/// Holds what the user decides besides the amount.
struct ContextWishes {
  std::map<NodeId, ContextRole> roles;  ///< replace the roles that were found
  bool hiddenToo = false;               ///< whether to draw structures hidden by hand as well
  bool operator==(const ContextWishes&) const = default;
};

/// Says that Γ of everything falls off with the distance from the targets or from a place.
struct FocusNearness {
  std::optional<glm::vec3> place;  ///< LPS, millimetres; absent: from the targets
  float falloffMm = 60.0f;         ///< from where on only silhouettes are drawn
  bool operator==(const FocusNearness&) const = default;
};
inline constexpr Limits<float> nearnessFalloffs{1.0f, 2000.0f};

struct Focus {
  std::vector<NodeId> targets;  ///< structures and groups as they were chosen; none: no focus
  ContextAmount amount = ContextAmount::clamped(0.5f);
  std::optional<Camera> seenFrom;  ///< from where nothing may hide it; absent: from all round
  ContextWishes wishes;
  /// Present: Γ follows the distance, and neither amount nor wishes count.
  std::optional<FocusNearness> nearness;
  /// What each structure was given when the focus was last applied, at most one for each. A
  /// structure that looks otherwise has been changed by hand since.
  std::vector<Look> given;
  std::string unread;  ///< like Node::unread
  bool operator==(const Focus&) const = default;
};

}  // namespace sline::model
