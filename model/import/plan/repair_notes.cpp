// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/repair_notes.h"

#include <utility>

namespace sline::model {

namespace {
/// Returns "214 faces given twice, 120 without area"; empty where neither was found.
std::string facesLeftOut(int twice, int withoutArea) {
  const auto faces = [](int count) {
    return std::to_string(count) + (count == 1 ? " face " : " faces ");
  };
  if (twice == 0)
    return withoutArea == 0 ? std::string() : faces(withoutArea) + "without area";
  const std::string first = faces(twice) + "given twice";
  return withoutArea == 0 ? first : first + ", " + std::to_string(withoutArea) + " without area";
}
}  // namespace

RepairNotes repairNotes(std::span<const Part> parts, const Sources& sources) {
  RepairNotes notes;
  int twice = 0;
  int withoutArea = 0;
  for (const Part& part : parts) {
    const RepairReport& repair = part.repair;
    const std::string faces = facesLeftOut(repair.duplicateFaces, repair.degenerateFaces);
    if (faces.empty())
      continue;
    twice += repair.duplicateFaces;
    withoutArea += repair.degenerateFaces;
    const std::string file = sources.files[part.file].file.filename().string();
    std::string line = file;
    line.append(": \"").append(part.name).append("\": ").append(faces);
    notes.surfaces.push_back(std::move(line));
  }
  if (!notes.surfaces.empty())
    notes.summary = "repaired " + std::to_string(notes.surfaces.size()) + " of " +
                    std::to_string(parts.size()) +
                    (parts.size() == 1 ? " surface: " : " surfaces: ") +
                    facesLeftOut(twice, withoutArea) + " left out";
  return notes;
}

}  // namespace sline::model
