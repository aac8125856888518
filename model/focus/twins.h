// SPDX-License-Identifier: Apache-2.0
// Finds what a scene shows twice: two versions of a structure, or two bodies in one place.
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Holds two structures of the same name, numbers aside. The second is the one with the higher
/// number.
struct Twins {
  NodeId first;
  NodeId second;
};

/// Returns the visible structures that lie where another of the same name lies, numbers aside: two
/// surfaces that nearly coincide, or, where half of all structures come in pairs whose boxes
/// overlap, the second body. Ribs and vertebrae have names that differ by numbers too but lie
/// beside each other. What stays in its file's own coordinates (a molecule) has no twin, as
/// molecules are laid over each other on purpose.
std::vector<Twins> twinsOf(const Scene& scene);

/// Returns a sentence that says so, or nothing where there are none.
std::string twinsText(const Scene& scene, const std::vector<Twins>& twins);

}  // namespace sline::model
