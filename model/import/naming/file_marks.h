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
/// Returns what may be shown of a name that a molecule's file gives one of its parts. Where that is
/// not of words that may be shown, what the reader calls it is left: of "Chain A – Doe's kinase"
/// "Chain A", of "Doe's drug (LIG)" "LIG". Names of elements stay.
std::string shownMoleculePart(const std::string& name);

}  // namespace sline::model
