// SPDX-License-Identifier: Apache-2.0
// Edits looks: several fields of a style at once, by hand or from a preset. A change to a group
// applies to everything in it, so the structures in it lose their own answers; they may be given
// others afterwards, or inherit again. Locked nodes keep their look (model/edit/locks.h).
#pragma once

#include <span>
#include <string>

#include "model/edit/edited.h"
#include "model/scene/style_fields.h"

namespace sline::model {

/// Holds a look that has a name. Fields without an answer stay as they are where the preset is
/// applied.
struct StylePreset {
  std::string name;
  Style style;
  bool operator==(const StylePreset&) const = default;
};

/// Gives the nodes those fields that `look` answers; the nodes below inherit them again. Unknown
/// ids are ignored. Where a colour is given and no ink, inks that were of the old colour, or of it
/// made dark or light enough for lines, follow.
Edited withLook(const Scene& scene, std::span<const NodeId> ids, const Style& look);
/// Lets the nodes, and all below them, inherit again the fields that `which` answers, whatever the
/// answers are. Inks follow colours here, too.
Edited withLookInherited(const Scene& scene, std::span<const NodeId> ids, const Style& which);

/// Returns how the node looks, inherited or not; an ink without a colour of its own stays
/// unanswered.
Style lookOf(const Scene& scene, NodeId id);

/// Tells whether neither a structure nor a group says how detailed or how filled it is drawn, nor a
/// saved view: such a scene may open with a look that is chosen for it (model/look).
bool hasNoLook(const Scene& scene);

/// Reduces the looks to what a press without colours or tones can print: black ink alone. Γ ends at
/// 3, where shading would begin. A structure that was shaded or filled hides what is behind it in
/// the colour of the paper; where that showed through – a wash, a veil, what was rather
/// transparent – it does not hide it at all. Cut faces become white, with hatching, and
/// labels have no colours.
Edited withInkAlone(const Scene& scene);

}  // namespace sline::model
