// SPDX-License-Identifier: Apache-2.0
// Finds the pockets of all molecules in a scene and makes them comparable: where molecules are laid
// over each other, pockets that share room or residues have the same number.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/pockets/pockets.h"
#include "model/scene/scene.h"

namespace sline::model {

/// Holds a molecule of the scene: the chains in one group.
struct PocketMolecule {
  NodeId group;  ///< the root where they are in none
  std::string name;
  std::vector<NodeId> chains;
  std::vector<std::string> residues;  ///< as AtomSet has them, of all its chains
  ProbeGrid grid;
};

struct ScenePocket {
  int number = 0;            ///< from 1; the same for matching pockets of several molecules
  std::size_t molecule = 0;  ///< in ScenePockets::molecules
  Pocket pocket;
  /// What lies in it for the most part, of any molecule: structures, or the groups that hold
  /// nothing else.
  std::vector<NodeId> guests;
};

struct ScenePockets {
  std::vector<PocketMolecule> molecules;  ///< in tree order
  std::vector<ScenePocket> pockets;       ///< by number, then by molecule

  /// Returns the names of the residues at the pocket's wall.
  std::vector<std::string> lining(const ScenePocket& pocket) const;
};

/// Returns the molecules whose chains keep their atoms, without grids; hidden chains do not count.
std::vector<PocketMolecule> moleculesIn(const Scene& scene);

/// Returns the pockets of all molecules. The error says why there is no answer, as that no
/// structure of the scene keeps its atoms.
Result<ScenePockets> pocketsIn(const Scene& scene, const PocketOptions& options,
                               const GoesOn& goesOn);

}  // namespace sline::model
