// SPDX-License-Identifier: Apache-2.0
// What of a molecule its surfaces carry along, so that entries can be laid over each other.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace sline::model {

struct BackboneChain {
  std::string id;
  bool nucleic = false;
  std::string letters;  ///< one-letter codes of the residues below
  std::vector<glm::dvec3>
      places;  ///< Cα, of nucleotides P (of the first one C4' where it has none)
};

struct Backbone {
  std::string entry;  ///< as people call it: "2SRC"
  std::vector<BackboneChain> chains;
  std::string note;  ///< what there is to be told of the entry that is no loss; may be empty
};

/// A surface's part in its molecule.
struct MoleculePart {
  enum class Role { chain, bonds, other } role = Role::other;
  std::size_t number = 0;                    ///< of the chain in its entry
  std::shared_ptr<const Backbone> backbone;  ///< the same for all surfaces of an entry; never null
};

}  // namespace sline::model
