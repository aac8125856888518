// SPDX-License-Identifier: Apache-2.0
// Reads tables that lie with a collection of meshes and say which structure is part of which.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sline::model {

/// Holds for each file (by its name) the groups above it, outermost first; files it does not know
/// are absent.
using GroupPaths = std::map<std::string, std::vector<std::string>>;

/// Looks in the folder, then beside it (in its parent), for MANIFEST.tsv with the columns "file"
/// and "system", or for the part-of tables of BodyParts3D (partof_inclusion_relation_list.txt and
/// partof_element_parts.txt; files are named by their element, "FJ3152_…"). Returns nothing where
/// there is no such table or it knows less than half of the files.
std::optional<GroupPaths> readPartOfTable(const std::filesystem::path& folder,
                                          std::span<const std::string> files);

}  // namespace sline::model
