// SPDX-License-Identifier: Apache-2.0
// Saved views: what a scene looks like in one, and how one is made of what is seen. They are named
// by where they stand, as their order is the tour's.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/edit/edited.h"

namespace sline::model {

struct ShownScene {
  Scene scene;
  std::vector<NodeId> absent;  ///< nodes the view speaks of that the scene lacks
};

/// The scene as the view shows it: its sections, looks and annotations, as far as it says; the rest
/// stays as it is. Nodes that came after the view stay as they are.
ShownScene shown(const Scene& scene, const View& view);

/// How all nodes look, such that `shown` brings it back: structures with what they inherit answered
/// (but for ink of no colour of its own), groups with whether they are visible.
std::vector<Look> looksOf(const Scene& scene);

/// How many of the nodes and annotations that the view speaks of the scene lacks.
std::size_t absentFrom(const Scene& scene, const View& view);

/// All that is seen now: camera, looks of all nodes, sections and the annotations that are shown.
View viewOf(const Scene& scene, const Camera& camera, std::string name);

/// The name without blanks at its ends; where another view goes by it (as `normalisedName`
/// compares), with the first number behind it that none has: "Front 2". `but`: that view may.
std::string freeViewName(const Scene& scene, const std::string& wanted,
                         std::optional<std::size_t> but = std::nullopt);

/// Returns the scene with these saved views instead of its own.
Edited withViews(const Scene& scene, std::vector<View> views);

/// The view stands last, by a free name. Without a name, or from a faulty camera, it is none.
Edited withView(const Scene& scene, View view);
/// The view shows what `seen` does, and keeps its name and what its file says beyond.
Edited withViewUpdated(const Scene& scene, std::size_t index, const View& seen);
/// By a free name; no name changes nothing.
Edited withViewRenamed(const Scene& scene, std::size_t index, const std::string& name);
/// It stands at `to` afterwards; beyond the end is the end.
Edited withViewMoved(const Scene& scene, std::size_t index, std::size_t to);
Edited withoutView(const Scene& scene, std::size_t index);

/// The scene with the key light, or without a word on it. A faulty light changes nothing.
Edited withKeyLight(const Scene& scene, const std::optional<KeyLight>& light);

}  // namespace sline::model
