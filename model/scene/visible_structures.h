// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

struct VisibleStructure {
  const Node* node = nullptr;  ///< of the scene that was asked
  ResolvedStyle style;
};

/// Returns the structures that can be seen, in tree order, in one pass: those with triangles that
/// neither their own style nor a group's hides.
std::vector<VisibleStructure> visibleStructures(const Scene& scene);

}  // namespace sline::model
