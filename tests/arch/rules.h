// SPDX-License-Identifier: Apache-2.0
// The house rules as functions from text to complaints, so that each can be shown to fail.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace sline::arch {

/// A file of the tree: its path from the top, with '/', and what is in it.
struct File {
  std::string path;
  std::string text;
};

using Complaints = std::vector<std::string>;

/// Includes follow the table of ARCHITECTURE.md: rooms, third-party libraries, no GL type in
/// headers outside render/gpu.
Complaints checkIncludes(const File& file);
/// A CMakeLists.txt links only targets of rooms below its own.
Complaints checkLinks(const File& file);
/// Header ≤ 250 lines, source ≤ 500, function ≤ 60, at most five parameters; `exceptions` are paths
/// that ARCHITECTURE.md names.
Complaints checkSizes(const File& file, const std::string& exceptions);
/// A source file includes its own header, if the tree has one, before anything else: so it shows
/// that the header compiles alone. `paths` are the tree's.
Complaints checkOwnHeaderFirst(const File& file, const std::set<std::string>& paths);
/// The first lines hold the licence's SPDX line.
Complaints checkLicenceLine(const File& file);
/// The top level holds exactly what was agreed.
Complaints checkTopLevel(const std::vector<std::string>& names);
/// The shared libraries a program needs hold no Qt but what sets text, and none of those that are
/// loaded only when a picture needs them.
Complaints checkNeeded(const std::string& neededLibraries);

}  // namespace sline::arch
