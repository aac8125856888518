// SPDX-License-Identifier: Apache-2.0
// States the house rules as functions from text to complaints, so that each can be shown to fail.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/arch/house.h"

namespace sline::arch {

using Complaints = std::vector<std::string>;

/// Checks that includes follow the tables of ARCHITECTURE.md: rooms, third-party libraries, no GL
/// type in headers outside render/gpu.
Complaints checkIncludes(const File& file, const House& house);
/// Checks that every permission of the table is used, and that its rooms have sources.
Complaints checkPermissions(const std::vector<File>& files, const House& house);
/// Checks that rooms include only those headers of each other that a CMakeLists.txt lists after
/// HEADERS, and that each of these is included by another room.
Complaints checkPublicHeaders(const std::vector<File>& sources, const std::vector<File>& lists);
/// Returns the targets that CMakeLists.txt of rooms define, and their folders.
std::map<std::string, std::string> targetsIn(const std::vector<File>& lists);
/// Checks that a CMakeLists.txt links only targets of rooms that its own may enter, and Qt's
/// widgets only in widgets and app.
Complaints checkLinks(const File& list, const std::map<std::string, std::string>& targets,
                      const House& house);
/// Checks sizes: header ≤ 250 lines, source ≤ 500, function ≤ 60, at most five parameters, except
/// in files that ARCHITECTURE.md lists as exceptions.
Complaints checkSizes(const File& file, const House& house);
/// Checks that no room holds more than 4,000 lines of C++, except those of `larger`, which hold no
/// more than is said there and still more than 4,000.
Complaints checkRoomSizes(const std::vector<File>& files, const House& house,
                          const std::map<std::string, std::size_t>& larger);
/// Checks that a source file includes its own header, if the tree has one, before anything else:
/// this shows that the header compiles alone. `paths` are the tree's.
Complaints checkOwnHeaderFirst(const File& file, const std::set<std::string>& paths);
/// Returns the sections of METHOD.md and the items in them: "7", "11.4".
std::set<std::string> methodSections(const std::string& method);
/// Checks that what a file cites of METHOD.md ("METHOD §7, §10", "METHOD §11.4") is there.
Complaints checkCitations(const File& file, const std::set<std::string>& sections);
/// Checks that errors which a function only hands on are handed on with `TRY`
/// (model/base/result.h), and that what is made in one is kept: `TRY(X::create());` ends it at
/// once.
Complaints checkTries(const File& file);
/// The first lines hold the licence's SPDX line.
Complaints checkLicenceLine(const File& file);
/// Checks that the top level holds exactly what was agreed.
Complaints checkTopLevel(const std::vector<std::string>& names);
/// Checks that the shared libraries a program needs hold no Qt except what sets text, and none of
/// those that are loaded only when a picture needs them.
Complaints checkNeeded(const std::string& neededLibraries);

}  // namespace sline::arch
