// SPDX-License-Identifier: Apache-2.0
#include "tests/arch/house.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

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

constexpr const char* tableHead = "| room | what it is for | may include |\n|---|---|---|\n";

/// Describes a room as its CMakeLists.txt does.
struct DeclaredRoom {
  std::string path;
  std::string about;
  std::vector<std::string> mayUse;
};

std::size_t layerRank(const std::string& path) {
  constexpr std::array layers{"model", "render", "app", "widgets"};
  return std::size_t(std::find(layers.begin(), layers.end(), layerOf(path)) - layers.begin());
}

std::vector<DeclaredRoom> declaredIn(const File& list) {
  static const std::regex declared(
      R"re(sline_(room|widget_room|folder)\(\s*([\w.]+)[^"()]*ABOUT\s+"([^"]*)"(\s+MAY_USE((\s+(?!HEADERS|SOURCES|DEPENDS|PRIVATE)[\w./*]+)+))?)re");
  const std::string home = list.path.substr(0, list.path.rfind('/'));
  std::vector<DeclaredRoom> rooms;
  for (std::sregex_iterator it(list.text.begin(), list.text.end(), declared), end; it != end;
       ++it) {
    DeclaredRoom& room = rooms.emplace_back();
    room.path = (*it)[1] == "folder" ? home + "/" + (*it)[2].str() : home;
    room.about = (*it)[3];
    std::istringstream names((*it)[5].str());
    for (std::string name; names >> name;)
      room.mayUse.push_back(name);
  }
  return rooms;
}

/// Writes "all of model; render/lines, strokes": a name without a layer is of the layer before it.
std::string cellOf(const std::vector<std::string>& mayUse) {
  std::string layers;
  std::string rooms;
  std::string before;
  for (const std::string& name : mayUse) {
    const std::string layer = layerOf(name);
    if (name == layer + "/*") {
      layers += (layers.empty() ? "all of " : ", ") + layer;
      continue;
    }
    rooms += (rooms.empty() ? "" : ", ") + (layer == before ? name.substr(layer.size() + 1) : name);
    before = layer;
  }
  if (layers.empty() && rooms.empty())
    return "nothing of ours";
  return layers + (layers.empty() || rooms.empty() ? "" : "; ") + rooms;
}

}  // namespace

std::string roomTable(const std::vector<File>& lists) {
  std::vector<DeclaredRoom> rooms;
  for (const File& list : lists)
    for (DeclaredRoom& room : declaredIn(list))
      rooms.push_back(std::move(room));
  std::sort(rooms.begin(), rooms.end(), [](const DeclaredRoom& a, const DeclaredRoom& b) {
    return std::pair(layerRank(a.path), a.path) < std::pair(layerRank(b.path), b.path);
  });
  std::string table = tableHead;
  for (const DeclaredRoom& room : rooms)
    table += "| " + room.path + " | " + room.about + " | " + cellOf(room.mayUse) + " |\n";
  return table;
}

std::string withRoomTable(const std::string& architecture, const std::string& table) {
  return architecture.substr(0, architecture.find(tableHead)) + table;
}

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
