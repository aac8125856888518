// SPDX-License-Identifier: Apache-2.0
// Reads what the CMakeLists.txt of rooms say of them, makes ARCHITECTURE.md's table of it, and
// reads that and its table of libraries: the rules have no list of their own.
#pragma once

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace sline::arch {

/// Holds a file of the tree: its path from the top, with '/', and its content.
struct File {
  std::string path;
  std::string text;
};

/// Describes a folder of sources, or a single source, and the rooms that it may include besides
/// itself.
struct Room {
  std::set<std::string> mayUse;
  std::set<std::string> wholeLayers;  ///< "render" where the table says "all of render"
};

/// Describes headers of another project and the only folders that may include them.
struct Library {
  std::string name;
  std::regex headers;
  std::vector<std::string> folders;
  bool sourcesAlone = false;  ///< no header may include it, except those of tests
};

struct House {
  std::map<std::string, Room> rooms;
  std::vector<Library> libraries;
  std::set<std::string> largeFiles;  ///< files that may exceed the limits of size
};

/// Returns the table of rooms, made of what `sline_room` and `sline_folder` (CMakeLists.txt at the
/// top) are given in these: what each is ABOUT, and what it MAY_USE.
std::string roomTable(const std::vector<File>& lists);
/// Returns the text with that table in place of its own, which ends it.
std::string withRoomTable(const std::string& architecture, const std::string& table);

/// Reads the tables under "| room | what it is for | may include |" and "| library | its headers |
/// only in |" and the list under "Exceptions from the sizes".
House houseOf(const std::string& architecture);

/// Returns the room that a file of the tree lies in: the file itself, or its folder; empty if the
/// table has neither.
std::string roomOf(const House& house, const std::string& path);

bool isUnder(const std::string& path, const std::string& folder);

std::vector<std::string> linesOf(const std::string& text);

}  // namespace sline::arch
