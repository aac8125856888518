// SPDX-License-Identifier: Apache-2.0
// The flags that put structures in focus and everything else in its place around them.
#pragma once

#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/focus/context.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// As typed.
struct FocusFlags {
  std::vector<std::string> names;
  double context = 0.5;
  bool contextGiven = false;
  std::string from = "camera";
};

struct FocusOrder {
  std::vector<std::string> names;  ///< none: no focus
  model::ContextAmount context;
  bool fromCamera = false;
};

/// An error is a wrong use, here and in the next one.
Result<FocusOrder> understood(const FocusFlags& flags);
/// The scene with the focus that was ordered, as `camera` sees it where the order says so. `cut` is
/// the same scene with its sections: what they take away hides nothing.
Result<model::Scene> focused(const model::Scene& scene, const FocusOrder& order,
                             const model::Scene& cut, const model::Camera& camera);

}  // namespace sline::cli
