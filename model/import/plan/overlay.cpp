// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/import/molecules/molecule_surfaces.h"
#include "model/import/molecules/superposition.h"

namespace sline::model {

namespace {

using BackbonePtr = std::shared_ptr<const Backbone>;

/// Returns the entries in the parts' order.
std::vector<BackbonePtr> entriesOf(const std::vector<Part>& parts) {
  std::vector<BackbonePtr> entries;
  for (const Part& part : parts)
    if (part.raw.molecule && (entries.empty() || entries.back() != part.raw.molecule->backbone))
      entries.push_back(part.raw.molecule->backbone);
  return entries;
}

std::string fitText(const Superposition& fit, const Backbone& fixed) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, ": %zu of %zu pairs of residues, %.0f %% identical, RMSD ",
                fit.kept, fit.aligned, 100.0 * fit.identity);
  std::string text =
      "chain " + fit.chain + " laid over chain " + fit.ontoChain + " of " + fixed.entry + numbers;
  const long thousandths = std::lround(1000.0 * fit.rmsd);
  std::snprintf(numbers, sizeof numbers, "%ld.%03ld Å", thousandths / 1000, thousandths % 1000);
  return text + numbers;
}

void move(RawMesh& raw, const RigidMotion& motion) {
  for (glm::vec3& p : raw.positions)
    p = glm::vec3(motion(glm::dvec3(p)));
  KeptAtoms& atoms = raw.molecule->atoms;
  if (!atoms.set)
    return;
  auto moved = std::make_shared<AtomSet>(*atoms.set);
  for (AtomBall& atom : moved->atoms)
    atom.place = glm::vec3(motion(glm::dvec3(atom.place)));
  atoms.set = std::move(moved);
}

void recolour(RawMesh& raw, std::size_t entry, std::size_t chainsBefore) {
  if (raw.molecule->role == MoleculeOrigin::Role::chain)
    raw.colour = chainColour(chainsBefore + raw.molecule->number);
  else if (raw.molecule->role == MoleculeOrigin::Role::bonds)
    raw.colour = bondColour(entry);
}

}  // namespace

std::vector<std::string> overlayMolecules(std::vector<Part>& parts, Overlay overlay) {
  const std::vector<BackbonePtr> entries = entriesOf(parts);
  std::vector<std::string> notes;
  for (const BackbonePtr& entry : entries)
    if (!entry->note.empty())
      notes.push_back(entry->entry + ": " + entry->note);
  if (entries.size() < 2)
    return notes;
  const bool onlyMolecules = std::all_of(
      parts.begin(), parts.end(), [](const Part& part) { return part.raw.molecule.has_value(); });
  std::size_t chains = 0;
  for (std::size_t entry = 0; entry < entries.size(); ++entry) {
    std::optional<Superposition> fit;
    if (entry > 0 && onlyMolecules && overlay == Overlay::automatic) {
      fit = superposition(*entries[entry], *entries.front());
      notes.push_back(entries[entry]->entry + ": " +
                      (fit ? fitText(*fit, *entries.front())
                           : "not laid over " + entries.front()->entry +
                                 ", since no chains match; it stays where its file has it"));
    }
    for (Part& part : parts) {
      if (!part.raw.molecule || part.raw.molecule->backbone != entries[entry])
        continue;
      recolour(part.raw, entry, chains);
      if (!fit)
        continue;
      move(part.raw, fit->motion);
      part.raw.frameReason = fitText(*fit, *entries.front());
    }
    chains += entries[entry]->chains.size();
  }
  return notes;
}

}  // namespace sline::model
