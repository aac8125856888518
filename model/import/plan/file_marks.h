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
/// Tells whether the file is called by the id of an entry of the Protein Data Bank: "2src.cif.gz",
/// or one of its assemblies: "4hhb-assembly1.cif".
bool isEntryFile(const std::filesystem::path& file);

/// Returns the same of the name of one of a file's surfaces: programs title them after files.
std::string partMark(const std::string& part);

}  // namespace sline::model
