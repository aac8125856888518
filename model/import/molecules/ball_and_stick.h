// SPDX-License-Identifier: Apache-2.0
// Builds small molecules as balls and sticks.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "model/import/molecules/molecule.h"
#include "model/import/molecules/surface/lattice_mesh.h"

namespace sline::model {

inline constexpr float ballShare = 0.3f;    ///< share of an atom's van der Waals radius
inline constexpr float ionShare = 0.5f;     ///< share for an ion on its own
inline constexpr float stickRadius = 0.2f;  ///< Å

/// Holds the atoms of one element; those of the main element are one smooth surface with all the
/// sticks.
struct ElementSurface {
  const Element* element = nullptr;
  bool withBonds = false;
  TriangleMesh mesh;
};

/// Returns one surface per element, that of the main element first: carbon, or the commonest where
/// there is none. Sticks end at the balls of other elements. Above 1,500 atoms balls and sticks are
/// coarse and pass through each other; above 20,000 the rest have no sticks.
std::vector<ElementSurface> ballAndStick(
    std::span<const Atom> atoms, const std::set<std::pair<std::int64_t, std::int64_t>>& bonds,
    const std::function<bool()>& goesOn);

/// Returns the balls of ions, all of one kind as one surface.
TriangleMesh balls(std::span<const Atom> atoms, float shareOfRadius);

}  // namespace sline::model
