// SPDX-License-Identifier: Apache-2.0
// An entry's records → chains, ligands, ions; waters counted.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/import/molecules/molecule.h"

namespace sline::model {

/// Chooses one alternative of each residue (the most occupied) and sorts residues: into chains what
/// mmCIF lists as polymer, amino acids, nucleotides and what is bonded into a chain like them, as a
/// phosphotyrosine; waters out; the rest into ligands, those bonded to each other into one.
Molecule moleculeOf(EntryRecords records);

/// The one-letter code of an amino acid or nucleotide, of a modified one that of what it was; 'X'
/// for any other.
char letterOf(std::string_view residue);

/// Pairs of atoms that are bonded: nearer than their covalent radii and 0.45 Å allow, or listed in
/// `known` by their serials.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bondsBetween(
    std::span<const Atom> atoms, const std::set<std::pair<std::int64_t, std::int64_t>>& known);

}  // namespace sline::model
