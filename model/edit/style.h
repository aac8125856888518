// SPDX-License-Identifier: Apache-2.0
// Edits of style: Scene → Scene. `changed` is false where the edit made no difference, so that a
// no-op leaves no undo step and no repaint. What is locked keeps its look (model/edit/locks.h).
#pragma once

#include <span>

#include "model/scene/scene.h"

namespace sline::model {

struct Edited {
  Scene scene;
  bool changed = false;
};

/// Sets those fields of the style that `patch` answers.
void patch(Style& style, const Style& patch);

/// The same for the nodes' own styles; unknown ids are ignored.
Edited withStyle(const Scene& scene, std::span<const NodeId> ids, const Style& given);
/// Clears the nodes' own styles, so that they inherit everything again.
Edited withStyleReset(const Scene& scene, std::span<const NodeId> ids);
/// Shows exactly the structures at or below the nodes: everything else is hidden, groups above the
/// shown ones are made visible.
Edited withOnlyVisible(const Scene& scene, std::span<const NodeId> ids);

/// What a press without colours or tones can print: black ink alone. Γ ends at 3, where shading
/// would begin; what was shaded or washed hides what is behind it in the colour of the paper, or
/// where it was rather transparent, not at all. Cut faces become white, with hatching.
Edited withInkAlone(const Scene& scene);

}  // namespace sline::model
