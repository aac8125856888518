// SPDX-License-Identifier: Apache-2.0
// Saved views: what a scene looks like in one, and how one is made of what is seen.
#pragma once

#include <vector>

#include "model/edit/style.h"

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

/// The scene with the key light, or without a word on it. A faulty light changes nothing.
Edited withKeyLight(const Scene& scene, const std::optional<KeyLight>& light);

}  // namespace sline::model
