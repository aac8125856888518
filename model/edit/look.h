// SPDX-License-Identifier: Apache-2.0
// Edits of looks: several fields of a style at once, by hand or from a preset. What is said of a
// group holds for all in it, so what structures in it said themselves is forgotten; they may say
// otherwise afterwards, and inherit again. What is locked keeps its look (model/edit/locks.h).
#pragma once

#include <span>
#include <string>

#include "model/edit/edited.h"
#include "model/scene/style_fields.h"

namespace sline::model {

/// A look that has a name. Fields without an answer stay as they are where it is put on.
struct StylePreset {
  std::string name;
  Style style;
  bool operator==(const StylePreset&) const = default;
};

/// Gives the nodes those fields that `look` answers; below them these are inherited again. Unknown
/// ids are ignored.
Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look);
/// Lets the nodes, and all below them, inherit again what `which` answers, whatever it answers.
Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which);

/// Returns how the node looks, inherited or not; ink that has no colour of its own stays
/// unanswered.
Style lookOf(const Scene& scene, NodeId id);

/// Reduces the looks to what a press without colours or tones can print: black ink alone. Γ ends
/// at 3, where shading would begin; what was shaded or washed hides what is behind it in the colour
/// of the paper, or where it was rather transparent, not at all. Cut faces become white, with
/// hatching.
Edited withInkAlone(const Scene& scene);

}  // namespace sline::model
