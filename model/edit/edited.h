// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene/scene.h"

namespace sline::model {

/// Holds the outcome of an edit Scene → Scene. `changed` is false where the edit made no
/// difference, so that it leaves no undo step and no repaint.
struct Edited {
  Scene scene;
  bool changed = false;
};

}  // namespace sline::model
