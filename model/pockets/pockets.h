// SPDX-License-Identifier: Apache-2.0
// Finds the pockets of a molecule: the places outside its atoms that a small ball reaches and a
// large one does not (Kawabata & Go, "Detection of pockets on protein surfaces using small and
// large probe spheres", Proteins 68, 2007; Kawabata, "Detection of multiscale pockets on protein
// surfaces using mathematical morphology", Proteins 78, 2010: the closing of the atoms by the large
// ball, less the atoms, opened by the small one). They work with bits on a lattice; here the
// lattice holds distances, exact ones to the atoms, so that pockets do not have its steps.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/pockets/probe_grid.h"

namespace sline::model {

/// Lengths and volumes are in the scene's mm, each drawn for 1 Å.
struct PocketOptions {
  float smallProbe = 1.4f;    ///< Å, the radius of a ball that goes into pockets: water
  float largeProbe = 5.0f;    ///< Å, of one that stays out
  float leastVolume = 50.0f;  ///< Å³
  float step = 0.5f;          ///< Å, of the lattice, where memory allows
  bool operator==(const PocketOptions&) const = default;
};
inline constexpr Limits<float> smallProbes{0.8f, 5.0f};
inline constexpr Limits<float> largeProbes{2.0f, 20.0f};
inline constexpr Limits<float> leastVolumes{1.0f, 10'000.0f};
inline constexpr Limits<float> latticeSteps{0.25f, 1.5f};
/// Returns what makes the options unusable, for an error message; empty where nothing does.
std::string pocketOptionsFault(const PocketOptions& options);

struct Pocket {
  double volume = 0.0;  ///< Å³
  double mouth = 0.0;   ///< Å², where it is open to the large ball; 0: it is a closed void
  float burial = 0.0f;  ///< the mean share of 14 directions in which atoms lie within 10 Å, 0 … 1
                        ///< (after LIGSITE: Hendlich, Rippmann, Barnickel, 1997)
  glm::dvec3 centre{0.0};  ///< mm
  /// Unit vector towards where most of the pocket can be seen from; zero where it has no mouth.
  glm::dvec3 outwards{0.0};
  std::vector<std::uint32_t> residues;  ///< those with an atom at its wall, ascending
  std::vector<std::uint32_t> cells;     ///< the places within, ascending
};

struct Pockets {
  ProbeGrid grid;
  std::vector<Pocket> list;  ///< the largest first
};

/// Returns the pockets between atoms; `residue` of each counts through all of them. The error says
/// why there is no answer: atoms that lie too far apart or too close together, or that the work is
/// not wanted any more.
Result<Pockets> findPockets(std::span<const AtomBall> atoms, const PocketOptions& options,
                            const GoesOn& goesOn);

}  // namespace sline::model
