// SPDX-License-Identifier: Apache-2.0
// Knows the ids of published entries of molecules, by which their files are called.
#pragma once

#include <filesystem>
#include <string>

namespace sline::model {

/// Tells whether the file is called by the id of a published entry: of the Protein Data Bank,
/// "2src.cif.gz" or "pdb_00002src.cif", or one of its assemblies, "4hhb-assembly1.cif"; or of the
/// AlphaFold Database, "AF-P69905-F1-model_v4.cif".
bool isEntryFile(const std::filesystem::path& file);

/// Tells whether a molecule's group, which its reader calls after file and title, is of such an
/// entry: "2SRC – Human tyrosine kinase, assembly 1". Its names are public and no one's.
bool isOfEntry(const std::string& group);

/// Returns how such an entry is cited: "PDB ID 2SRC", "AlphaFold DB P69905"; nothing for others.
std::string entryCitation(const std::filesystem::path& file);

}  // namespace sline::model
