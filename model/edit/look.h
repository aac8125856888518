// SPDX-License-Identifier: Apache-2.0
// Looks: several fields of a style at once, by hand or from a preset (see model/edit/style.h for
// `Edited`). What is said of a group holds for all in it; what is locked keeps its look.
#pragma once

#include <string>

#include "model/edit/style.h"

namespace sline::model {

/// A look that has a name. Fields without an answer stay as they are where it is put on.
struct StylePreset {
  std::string name;
  Style style;
  bool operator==(const StylePreset&) const = default;
};

/// The nodes with those fields that `look` answers; below them they are inherited again.
Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look);
/// The nodes, and all below them, inherit again what `which` answers, whatever it answers.
Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which);

/// Those answers of the style for whose fields `which` has any.
Style picked(const Style& style, const Style& which);
/// How the node looks, inherited or not; ink that has no colour of its own stays unanswered.
Style lookOf(const Scene& scene, NodeId id);

}  // namespace sline::model
