// SPDX-License-Identifier: Apache-2.0
// Finds what a scene is about (METHOD §12.2).
#pragma once

#include <string>
#include <vector>

#include "model/focus/tissues.h"

namespace sline::model {

/// Holds structures that a picture may be about.
struct Subject {
  std::string title;               ///< English: "organs", "urinary system", "everything"
  std::vector<NodeId> structures;  ///< in tree order, pockets last
  bool everything = false;         ///< nothing is left to be context
  /// Those of the structures that line the pocket of a ligand. Import hides them, as they lie on
  /// the chains; as a subject they are shown.
  std::vector<NodeId> pockets;
};

/// Returns what the scene may be about, the likeliest first: ligands with what lines their pockets
/// and lesions, organs, what lies inside hulls where no name tells anything, joints, vessels and
/// nerves, bones, then each single system, at last everything. Hidden structures do not count,
/// pockets aside, nor does what is there twice; each set of structures is returned once. Empty
/// where nothing is visible.
std::vector<Subject> subjectsOf(const Scene& scene);

}  // namespace sline::model
