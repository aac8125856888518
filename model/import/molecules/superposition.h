// SPDX-License-Identifier: Apache-2.0
// Lays one molecule over another: finds the chains that match best by sequence, and the rigid
// motion that brings their backbones together.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "model/import/source/backbone.h"

namespace sline::model {

/// Describes the motion x → rotation · (x − from) + to; the rotation is proper, nothing is ever
/// mirrored.
struct RigidMotion {
  glm::dmat3 rotation{1.0};
  glm::dvec3 from{0.0, 0.0, 0.0};
  glm::dvec3 to{0.0, 0.0, 0.0};
  glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * (p - from) + to; }
};

/// Returns the least-squares motion from the first points of the pairs to the second (Theobald,
/// Acta Cryst. A61, 2005, as gemmi implements it); a translation alone where they leave the
/// rotation undetermined.
RigidMotion rigidFit(std::span<const std::pair<glm::dvec3, glm::dvec3>> pairs);

struct Alignment {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::size_t identical = 0;
  double score = 0.0;
};

/// Returns the global alignment of two sequences (Needleman & Wunsch, J. Mol. Biol. 48, 1970, with
/// Gotoh's gaps: 11 to open, 1 to extend, free at the ends), scored by BLOSUM62 (Henikoff &
/// Henikoff, PNAS 89, 1992), nucleotides by +5 and −4. Returns nothing for sequences of more than
/// 150 million pairs.
std::optional<Alignment> aligned(std::string_view a, std::string_view b, bool nucleic);

struct Superposition {
  RigidMotion motion;
  double rmsd = 0.0;        ///< Å, over the pairs kept
  std::size_t kept = 0;     ///< pairs within 2 Å of each other in the end
  std::size_t aligned = 0;  ///< pairs in the alignment of the sequences
  double identity = 0.0;    ///< share of the aligned pairs that are identical
  std::string chain;        ///< the chain of the moving molecule
  std::string ontoChain;
};

/// Lays `moving` over `fixed` by the pair of chains that aligns best. Pairs far apart are left out
/// step by step until all that remain are within 2 Å, so that a domain that has moved does not
/// spoil the rest. Returns nothing where no chains match: fewer than six pairs, less than a quarter
/// identical, or fewer than a third of the pairs left.
std::optional<Superposition> superposition(const Backbone& moving, const Backbone& fixed);

}  // namespace sline::model
