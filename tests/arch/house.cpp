// SPDX-License-Identifier: Apache-2.0
#include "tests/arch/house.h"

#include <algorithm>
#include <sstream>

namespace sline::arch {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" `");
  const std::size_t last = text.find_last_not_of(" `");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> parts(const std::string& text, char between) {
  std::vector<std::string> all;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, between);)
    if (!trimmed(part).empty())
      all.push_back(trimmed(part));
  return all;
}

std::string layerOf(const std::string& name) {
  for (const char* layer : {"model", "render", "widgets", "app", "tests"})
    if (isUnder(name, layer))
      return layer;
  return {};
}

/// Splits "model/base, scene, render/lines": a name without a layer belongs to the layer before it.
std::vector<std::string> names(const std::string& cell) {
  std::vector<std::string> all;
  std::string layer;
  for (const std::string& name : parts(cell, ',')) {
    const std::string own = layerOf(name);
    all.push_back(own.empty() ? layer + "/" + name : name);
    if (!own.empty())
      layer = own;
  }
  return all;
}

Room roomIn(const std::string& cell) {
  Room room;
  if (cell == "nothing of ours")
    return room;
  std::string rooms = cell;
  if (cell.starts_with("all of ")) {
    const std::vector<std::string> both = parts(cell.substr(7), ';');
    for (const std::string& layer : parts(both.front(), ','))
      room.wholeLayers.insert(layer);
    if (both.size() == 1)
      return room;
    rooms = both.back();
  }
  for (const std::string& name : names(rooms))
    room.mayUse.insert(name);
  return room;
}

/// Reads "Q*, vtk*", in which stars stand for anything.
std::regex headersIn(const std::string& cell) {
  std::string pattern;
  for (const std::string& header : parts(cell, ',')) {
    pattern += pattern.empty() ? "" : "|";
    for (const char c : header)
      pattern += c == '*' ? std::string(".*") : c == '.' ? std::string("\\.") : std::string(1, c);
  }
  return std::regex(pattern);
}

Library libraryIn(const std::vector<std::string>& cells) {
  constexpr const char* alone = ", never in a header";
  std::string folders = cells[2];
  const std::size_t said = folders.find(alone);
  Library library{.name = cells[0],
                  .headers = headersIn(cells[1]),
                  .folders = {},
                  .sourcesAlone = said != std::string::npos};
  if (library.sourcesAlone)
    folders.erase(said, std::string(alone).size());
  library.folders = names(folders);
  return library;
}

}  // namespace

bool isUnder(const std::string& path, const std::string& folder) {
  return path == folder || path.starts_with(folder + "/");
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

House houseOf(const std::string& architecture) {
  House house;
  enum class Part { none, rooms, libraries, exceptions } part = Part::none;
  for (const std::string& line : linesOf(architecture)) {
    if (line.starts_with("#"))
      part = line.find("Exceptions from the sizes") != std::string::npos ? Part::exceptions
                                                                         : Part::none;
    if (part == Part::exceptions && line.starts_with("- "))
      house.largeFiles.insert(trimmed(line.substr(2, line.find(':') - 2)));
    if (!line.starts_with("|"))
      continue;
    const std::vector<std::string> cells = parts(line, '|');
    if (cells.front() == "room")
      part = Part::rooms;
    else if (cells.front() == "library")
      part = Part::libraries;
    else if (line.starts_with("|-"))
      continue;
    else if (part == Part::rooms && cells.size() == 3)
      for (const std::string& name : names(cells[0]))
        house.rooms[name] = roomIn(cells[2]);
    else if (part == Part::libraries && cells.size() == 3)
      house.libraries.push_back(libraryIn(cells));
  }
  return house;
}

std::string roomOf(const House& house, const std::string& path) {
  if (house.rooms.contains(path))
    return path;
  const std::string folder = path.substr(0, path.rfind('/'));
  return house.rooms.contains(folder) ? folder : std::string();
}

}  // namespace sline::arch
