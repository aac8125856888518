// SPDX-License-Identifier: Apache-2.0
// Describes the part of a molecule that its surfaces carry along, so that entries can be laid over
// each other.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "model/geometry/atom_set.h"

namespace sline::model {

struct BackboneChain {
  std::string id;
  bool nucleic = false;
  std::string letters;  ///< one-letter codes of the residues below
  std::vector<glm::dvec3>
      places;  ///< Cα, for nucleotides P (for the first one C4' where it has none)
};

struct Backbone {
  std::string entry;  ///< as people call it: "2SRC"
  std::vector<BackboneChain> chains;
  std::string note;  ///< a note about the entry for the user that is no loss; may be empty
};

/// Describes a surface's part in its molecule.
struct MoleculeOrigin {
  enum class Role { chain, bonds, other } role = Role::other;
  std::size_t number = 0;                    ///< number of the chain in its entry
  std::shared_ptr<const Backbone> backbone;  ///< shared by all surfaces of an entry; never null
  KeptAtoms atoms = {};  ///< those of a chain, in the coordinates of its surface
};

}  // namespace sline::model
