// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/mesh_folder.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "model/disk/whole_file.h"
#include "model/scene_file/ply_writer.h"

namespace sline::cli {

namespace fs = std::filesystem;

namespace {
constexpr const char* listName = "sline-files.txt";
constexpr const char* listTitle = "Files written by sline; writing here again replaces them.";
constexpr std::size_t largestFolderList = std::size_t(1) << 20;

std::string fileName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '-');
  return name.empty() || name.front() == '.' ? "_" + name : name;
}

/// Returns the file's path below the folder written to: "Veins/portal vein.ply".
fs::path placeOf(const model::Scene& scene, const model::Node& node) {
  fs::path place = fileName(node.name) + ".ply";
  for (const model::Node* up = scene.find(node.parent); up; up = scene.find(up->parent))
    place = fileName(up->name) / place;
  return place;
}

Error notOurs(const fs::path& path, const std::string& reason) {
  return {.file = path.string(), .reason = reason, .remedy = "Name a new or an empty folder"};
}

bool leadsOutside(const fs::path& place) {
  return place.empty() || place.is_absolute() ||
         std::find(place.begin(), place.end(), fs::path("..")) != place.end();
}

/// Returns the files that an earlier run wrote there; none for a new or empty folder.
Result<std::set<fs::path>> writtenBefore(const fs::path& folder) {
  std::error_code failure;
  if (!fs::exists(folder, failure))
    return std::set<fs::path>();
  if (!fs::is_directory(folder, failure))
    return notOurs(folder, "it is a file");
  if (!fs::exists(folder / listName, failure)) {
    const bool empty = fs::is_empty(folder, failure);
    if (failure)
      return notOurs(folder, "it cannot be read: " + failure.message());
    if (!empty)
      return notOurs(folder, "it holds files that no earlier run wrote");
    return std::set<fs::path>();
  }
  const std::string list = TRY(model::readText(folder / listName, largestFolderList));
  std::istringstream lines(list);
  std::string line;
  if (!std::getline(lines, line) || line != listTitle)
    return notOurs(folder / listName, "it is not the list of an earlier run");
  std::set<fs::path> places;
  while (std::getline(lines, line)) {
    if (leadsOutside(line))
      return notOurs(folder / listName, "it names \"" + line + "\", which is not in the folder");
    places.insert(line);
  }
  return places;
}

/// Writes the list, which comes first: it names what is there even if the writing stops half way.
Status writeList(const fs::path& folder, const std::set<fs::path>& places) {
  std::string list = std::string(listTitle) + "\n";
  for (const fs::path& place : places)
    list += place.generic_string() + "\n";
  return model::writeText(folder / listName, list);
}

void removeFiles(const fs::path& folder, const std::set<fs::path>& places) {
  std::error_code ignored;
  for (const fs::path& place : places) {
    fs::remove(folder / place, ignored);
    // Only folders that are left empty are removed.
    for (fs::path up = place.parent_path(); !up.empty(); up = up.parent_path())
      fs::remove(folder / up, ignored);
  }
}
}  // namespace

Status writeMeshFolder(const model::Scene& scene, const fs::path& folder) {
  const std::set<fs::path> before = TRY(writtenBefore(folder));
  std::set<fs::path> places;
  std::error_code failure;
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    const fs::path place = placeOf(scene, node);
    if (!places.insert(place).second)
      return notOurs(folder / place, "two structures would be written to it");
    if (!before.contains(place) && fs::exists(folder / place, failure))
      return notOurs(folder / place, "it is there and no earlier run wrote it");
  }
  fs::create_directories(folder, failure);
  if (failure)
    return notOurs(folder, "it cannot be made: " + failure.message());
  std::set<fs::path> all = places;
  all.insert(before.begin(), before.end());
  TRY(writeList(folder, all));
  removeFiles(folder, before);
  for (const model::Node& node : scene.nodes()) {
    if (node.isGroup())
      continue;
    const fs::path file = folder / placeOf(scene, node);
    fs::create_directories(file.parent_path(), failure);
    TRY(model::writeText(file, plyText(*node.mesh, "SPACE=LPS")));
  }
  return writeList(folder, places);
}

}  // namespace sline::cli
