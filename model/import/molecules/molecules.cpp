// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/molecules.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "model/base/letters.h"
#include "model/import/molecules/assemblies.h"
#include "model/import/molecules/entry_files.h"
#include "model/import/molecules/molecule_surfaces.h"
#include "model/import/molecules/residues.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

/// This distance, in Å, is farther from the middle than any molecule reaches, and than a float
/// resolves an atom.
constexpr double farthest = 50'000.0;

glm::dvec3 medianPlace(const std::vector<AtomRecord>& atoms) {
  glm::dvec3 median(0.0);
  std::vector<double> values(atoms.size());
  for (int a = 0; a < 3; ++a) {
    for (std::size_t i = 0; i < atoms.size(); ++i)
      values[i] = atoms[i].place[a];
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[a] = *middle;
  }
  return median;
}

/// Leaves out atoms that no surface can hold together with the others, and returns their number.
std::size_t leaveOutStrays(std::vector<AtomRecord>& atoms) {
  const glm::dvec3 middle = medianPlace(atoms);
  return std::erase_if(atoms, [&](const AtomRecord& atom) {
    const glm::dvec3 off = glm::abs(atom.place - middle);
    const glm::dvec3 own = glm::abs(atom.place);
    return !(std::max({off.x, off.y, off.z, own.x, own.y, own.z}) < farthest);
  });
}

/// Returns "1crn" for "1crn.pdb" and for "1crn.pdb.gz".
std::string entryName(const std::filesystem::path& file) {
  const bool packed = equalsIgnoringCase(file.extension().string(), ".gz");
  return (packed ? file.stem() : file).stem().string();
}

/// Leaves records out and returns warnings that say which.
std::vector<ImportWarning> leaveOut(EntryRecords& entry, const Source& source) {
  std::vector<ImportWarning> warnings;
  const auto warn = [&](std::size_t count, const std::string& one, const std::string& many) {
    if (count > 0)
      warnings.push_back(source.warning(std::to_string(count) + (count == 1 ? one : many)));
  };
  if (!entry.cutShort.empty())
    warnings.push_back(source.warning(entry.cutShort + "; what stands there and behind it was "
                                                       "not read"));
  warn(entry.otherModels, " further model left out; the first is drawn",
       " further models left out; the first is drawn");
  warn(entry.unreadable, " atom without coordinates left out",
       " atoms without coordinates left out");
  warn(leaveOutStrays(entry.atoms), " atom more than 50,000 Å from the others left out",
       " atoms more than 50,000 Å from the others left out");
  return warnings;
}

Result<RawMeshes> read(const std::filesystem::path& file, const ReadOptions& options,
                       Result<EntryRecords> (*records)(const Source&)) {
  const Source source = TRY(Source::read(file, options.limits));
  EntryRecords entry = TRY(records(source));
  if (!options.assembly.empty()) {
    TRY(assemble(source, entry, options.assembly));
  } else if (differFromTheirAtoms(entry.assemblies)) {
    entry.notes.told = assembliesText(entry.assemblies) + "; drawn are its atoms as they are";
  }
  const std::vector<ImportWarning> warnings = leaveOut(entry, source);
  if (entry.atoms.empty())
    return source.whole("its atoms lie too far from the origin to be drawn",
                        "Move the molecule to the origin");
  RawMeshes meshes =
      surfacesOf(moleculeOf(std::move(entry)), source.file(), entryName(file), options);
  meshes.warnings.insert(meshes.warnings.begin(), warnings.begin(), warnings.end());
  if (meshes.meshes.empty())
    return source.whole("holds nothing that can be drawn" +
                            (meshes.warnings.empty() ? "" : ": " + meshes.warnings.back().reason),
                        "Give an entry with a chain or a ligand");
  return meshes;
}

}  // namespace

Result<RawMeshes> readPdb(const std::filesystem::path& file, const ReadOptions& options) {
  return read(file, options, readPdbRecords);
}

Result<RawMeshes> readMmcif(const std::filesystem::path& file, const ReadOptions& options) {
  return read(file, options, readMmcifRecords);
}

Result<RawMeshes> readMmjson(const std::filesystem::path& file, const ReadOptions& options) {
  return read(file, options, readMmjsonRecords);
}

}  // namespace sline::model
