// SPDX-License-Identifier: Apache-2.0
// Tells what is in focus.
#pragma once

#include "model/scene/scene.h"

namespace sline::model {

/// Tells whether the node is one of those that were put in focus, or lies below one.
bool isInFocus(const Scene& scene, NodeId id);

}  // namespace sline::model
