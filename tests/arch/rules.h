// SPDX-License-Identifier: Apache-2.0
// The house rules as functions from text to complaints, so that each can be shown to fail.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/arch/house.h"

namespace sline::arch {

/// A file of the tree: its path from the top, with '/', and what is in it.
struct File {
  std::string path;
  std::string text;
};

using Complaints = std::vector<std::string>;

/// Includes follow the tables of ARCHITECTURE.md: rooms, third-party libraries, no GL type in
/// headers outside render/gpu.
Complaints checkIncludes(const File& file, const House& house);
/// What the table permits is done, and its rooms have sources.
Complaints checkPermissions(const std::vector<File>& files, const House& house);
/// Rooms include those headers of each other that a CMakeLists.txt lists after HEADERS, and each of
/// these is included by some.
Complaints checkPublicHeaders(const std::vector<File>& sources, const std::vector<File>& lists);
/// The targets that CMakeLists.txt of rooms define, and their folders.
std::map<std::string, std::string> targetsIn(const std::vector<File>& lists);
/// A CMakeLists.txt links only targets of rooms that its own may enter, and Qt's widgets only in
/// widgets and app.
Complaints checkLinks(const File& list, const std::map<std::string, std::string>& targets,
                      const House& house);
/// Header ≤ 250 lines, source ≤ 500, function ≤ 60, at most five parameters, but for files that
/// ARCHITECTURE.md lists as exceptions.
Complaints checkSizes(const File& file, const House& house);
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
