// SPDX-License-Identifier: Apache-2.0
// Keeps the atoms that a chain's surface encloses, so that pockets between them can be found at any
// time, with probes of any size, after the file is closed.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

namespace sline::model {

struct AtomBall {
  glm::vec3 place{0.0f};      ///< in the frame of the surface, mm; 1 Å is drawn as 1 mm
  float radius = 0.0f;        ///< van der Waals', mm
  std::uint32_t residue = 0;  ///< in `residues`
  bool operator==(const AtomBall&) const = default;
};

/// Molecules of more atoms are kept without them.
inline constexpr std::size_t mostKeptAtoms = 60'000;

struct AtomSet {
  std::vector<std::string> residues;  ///< "LYS A 295": name, chain and number
  std::vector<AtomBall> atoms;        ///< by ascending residues
  bool operator==(const AtomSet&) const = default;
};

/// Holds a set that all copies of a scene share; equal sets are equal wherever they are kept.
struct KeptAtoms {
  std::shared_ptr<const AtomSet> set;  ///< null: none are known
  bool operator==(const KeptAtoms& other) const {
    return set == other.set || (set && other.set && *set == *other.set);
  }
};

}  // namespace sline::model
