// SPDX-License-Identifier: Apache-2.0
// Says what a scene keeps of the names of the files that it came from and of the surfaces in them,
// so that it can travel.
#pragma once

#include <filesystem>
#include <string>

namespace sline::model {

/// Returns the file's name where it may be shown to others (model/anatomy/shown_names.h), else "#"
/// and a checksum of it, by which the file is found again.
std::string fileMark(const std::filesystem::path& file);
/// Returns the same of the name that a surface has in its file.
std::string partMark(const std::string& part);
/// Tells whether the file is called by the id of a published entry: of the Protein Data Bank,
/// "2src.cif.gz" or "pdb_00002src.cif", or one of its assemblies, "4hhb-assembly1.cif"; or of the
/// AlphaFold Database, "AF-P69905-F1-model_v4.cif".
bool isEntryFile(const std::filesystem::path& file);

/// Tells whether a molecule's group, which its reader calls after file and title, is of such an
/// entry: "2SRC – Human tyrosine kinase, assembly 1". Its names are public and no one's.
bool isOfEntry(const std::string& group);
/// Returns what may be shown of a name that a molecule's file gives one of its parts. Where that is
/// not of words that may be shown, what the reader calls it is left: of "Chain A – Doe's kinase"
/// "Chain A", of "Doe's drug (LIG)" "LIG". Names of elements stay.
std::string shownMoleculePart(const std::string& name);

}  // namespace sline::model
