// SPDX-License-Identifier: Apache-2.0
#include "model/scene/in_focus.h"

#include <algorithm>

namespace sline::model {

bool isInFocus(const Scene& scene, NodeId id) {
  const std::vector<NodeId>& targets = scene.focus().targets;
  return std::any_of(targets.begin(), targets.end(),
                     [&](NodeId target) { return target == id || scene.isBelow(id, target); });
}

}  // namespace sline::model
