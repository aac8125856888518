// SPDX-License-Identifier: Apache-2.0
// What ARCHITECTURE.md says of rooms and libraries, read from its tables: the rules have no list of
// their own.
#pragma once

#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace sline::arch {

/// A folder of sources, or a single source, and the rooms that it may include besides itself.
struct Room {
  std::set<std::string> mayUse;
  std::set<std::string> wholeLayers;  ///< "render" where the table says "all of render"
};

/// Headers of others, and the folders that alone may include them.
struct Library {
  std::string name;
  std::regex headers;
  std::vector<std::string> folders;
  bool sourcesAlone = false;  ///< in no header but of tests
};

struct House {
  std::map<std::string, Room> rooms;
  std::vector<Library> libraries;
  std::set<std::string> largeFiles;  ///< that may pass the limits of size
};

/// Reads the tables under "| room | what it is for | may include |" and "| library | its headers |
/// only in |" and the list under "Exceptions from the sizes".
House houseOf(const std::string& architecture);

/// Returns the room that a file of the tree lies in: itself, or its folder; empty where the table
/// has neither.
std::string roomOf(const House& house, const std::string& path);

bool isUnder(const std::string& path, const std::string& folder);

std::vector<std::string> linesOf(const std::string& text);

}  // namespace sline::arch
