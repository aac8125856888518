// SPDX-License-Identifier: Apache-2.0
// Checks paths that files give, which may come from any author.
#pragma once

#include <filesystem>

namespace sline::model {

/// Tells whether a path that a file gives stays in the folder it is relative to: it is not absolute
/// and never climbs out.
bool staysBelow(const std::filesystem::path& path);

/// Returns where a path leads with all its links followed, even a last one that leads to nothing
/// yet.
std::filesystem::path realPath(const std::filesystem::path& path);
/// Tells whether the path leads below the folder, links followed.
bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace sline::model
