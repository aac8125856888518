// SPDX-License-Identifier: Apache-2.0
// Declares the flags that put structures in focus and arrange everything else around them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/focus/context.h"
#include "model/scene/scene.h"

namespace sline::cli {

/// Holds the flags as typed.
struct FocusFlags {
  std::vector<std::string> names;
  double context = 0.5;
  bool contextGiven = false;
  std::string from = "camera";
  std::string near;
  std::optional<double> falloff;
};

struct FocusSpec {
  std::vector<std::string> names;  ///< empty: no focus
  model::ContextAmount context;
  bool fromCamera = false;
  std::string near;  ///< names, or a place as three numbers; empty: Γ does not follow nearness
  std::optional<float> falloffMm;  ///< absent: what suits the scene

  bool any() const { return !names.empty() || !near.empty(); }
};

/// Reads the flags. An error counts as wrong use, here and in `focused`.
Result<FocusSpec> parseFlags(const FocusFlags& flags);
/// Returns the scene with the focus that was ordered, as seen by `camera` if the order says so.
/// `cut` is the same scene with its sections: what they take away hides nothing.
Result<model::Scene> focused(const model::Scene& scene, const FocusSpec& spec,
                             const model::Scene& cut, const model::Camera& camera);

}  // namespace sline::cli
