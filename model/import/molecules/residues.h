// SPDX-License-Identifier: Apache-2.0
// Sorts an entry's records into chains, ligands and ions, and counts its waters.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "model/import/molecules/molecule.h"

namespace sline::model {

/// Chooses one alternative of each residue (the most occupied) and sorts the residues. Chains take
/// what mmCIF lists as polymer, amino acids, nucleotides, and residues that are bonded into a chain
/// like them, such as a phosphotyrosine; waters are left out; the rest become ligands, those bonded
/// to each other becoming one.
Molecule moleculeOf(EntryRecords records);

/// Returns the one-letter code of an amino acid or nucleotide, for a modified one that of the
/// residue it was; 'X' for any other.
char letterOf(std::string_view residue);

/// Returns the pairs of atoms that are bonded: nearer than their covalent radii and 0.45 Å allow,
/// or listed in `known` by their serials.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bondsBetween(
    std::span<const Atom> atoms, const std::set<std::pair<std::int64_t, std::int64_t>>& known);

}  // namespace sline::model
