// SPDX-License-Identifier: Apache-2.0
#include "model/pockets/scene_pockets.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace sline::model {

namespace {

// A guest has at least this share of its vertices in the pocket.
constexpr double guestShare = 0.5;
// Pockets match that share at least this part of the smaller one's room, or of all residues at
// their walls.
constexpr double sharedRoom = 0.3;
constexpr double sharedResidues = 0.3;
constexpr std::size_t mostSamples = 2000;

std::vector<AtomBall> atomsOf(const Scene& scene, const PocketMolecule& molecule) {
  std::vector<AtomBall> all;
  std::uint32_t first = 0;
  for (const NodeId chain : molecule.chains) {
    const AtomSet& set = *scene.find(chain)->atoms.set;
    for (AtomBall atom : set.atoms) {
      atom.residue += first;
      all.push_back(atom);
    }
    first += std::uint32_t(set.residues.size());
  }
  return all;
}

bool isIn(const ProbeGrid& grid, const Pocket& pocket, const glm::dvec3& place) {
  const glm::ivec3 cell = grid.cellAt(place);
  return grid.holds(cell) &&
         std::binary_search(pocket.cells.begin(), pocket.cells.end(), grid.index(cell));
}

/// Returns the share of places that lie in the pocket; of many, an evenly chosen part is asked.
template <class PlaceAt>
double shareWithin(const ProbeGrid& grid, const Pocket& pocket, std::size_t count,
                   const PlaceAt& placeAt) {
  const std::size_t stride = 1 + count / mostSamples;
  std::size_t within = 0;
  std::size_t all = 0;
  for (std::size_t i = 0; i < count; i += stride) {
    within += isIn(grid, pocket, placeAt(i)) ? 1 : 0;
    ++all;
  }
  return all > 0 ? double(within) / double(all) : 0.0;
}

bool isGuest(const Node& node, const ProbeGrid& grid, const Pocket& pocket) {
  const Box& box = node.mesh->bounds();
  if (!isIn(grid, pocket, glm::dvec3(box.centre())) &&
      glm::distance(glm::dvec3(box.centre()), pocket.centre) > 100.0)
    return false;
  const auto& positions = node.mesh->positions();
  return shareWithin(grid, pocket, positions.size(),
                     [&](std::size_t i) { return glm::dvec3(positions[i]); }) >= guestShare;
}

/// Puts in the place of structures the groups that hold nothing else, from below upwards.
std::vector<NodeId> withGroups(const Scene& scene, const std::vector<NodeId>& structures) {
  std::set<NodeId> chosen(structures.begin(), structures.end());
  std::vector<NodeId> groups;
  for (const NodeId id : structures) {
    const NodeId parent = scene.find(id)->parent;
    const std::vector<NodeId> all = scene.structuresBelow(parent);
    const bool whole = parent != rootId && std::all_of(all.begin(), all.end(), [&](NodeId other) {
                         return chosen.contains(other);
                       });
    const NodeId shown = whole && all.size() > 1 ? parent : id;
    if (std::find(groups.begin(), groups.end(), shown) == groups.end())
      groups.push_back(shown);
  }
  return groups;
}

std::vector<NodeId> guestsOf(const Scene& scene, const ProbeGrid& grid, const Pocket& pocket) {
  std::vector<NodeId> structures;
  for (const Node& node : scene.nodes())
    if (node.mesh && !node.atoms.set && node.style.visible.value_or(true) &&
        isGuest(node, grid, pocket))
      structures.push_back(node.id);
  return withGroups(scene, structures);
}

/// How far two pockets of different molecules are the same, 0 … 1.
double likeness(const ScenePockets& found, const ScenePocket& a, const ScenePocket& b) {
  const ProbeGrid& gridA = found.molecules[a.molecule].grid;
  const ProbeGrid& gridB = found.molecules[b.molecule].grid;
  const bool aIsSmaller = a.pocket.volume < b.pocket.volume;
  const ScenePocket& small = aIsSmaller ? a : b;
  const ScenePocket& large = aIsSmaller ? b : a;
  const ProbeGrid& own = aIsSmaller ? gridA : gridB;
  const double room =
      shareWithin(aIsSmaller ? gridB : gridA, large.pocket, small.pocket.cells.size(),
                  [&](std::size_t i) { return own.place(own.cell(small.pocket.cells[i])); });
  std::vector<std::string> at = found.lining(a);
  std::vector<std::string> bt = found.lining(b);
  std::sort(at.begin(), at.end());
  std::sort(bt.begin(), bt.end());
  std::vector<std::string> both;
  std::set_intersection(at.begin(), at.end(), bt.begin(), bt.end(), std::back_inserter(both));
  const double all = double(at.size() + bt.size() - both.size());
  const double residues = all > 0.0 ? double(both.size()) / all : 0.0;
  return room >= sharedRoom || residues >= sharedResidues ? std::max(room, residues) : 0.0;
}

/// Numbers the pockets of one molecule after those of the molecules before it: the most alike take
/// each other's number first.
void number(ScenePockets& found, std::size_t first, int& highest) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t own = first; own < found.pockets.size(); ++own)
    for (std::size_t other = 0; other < first; ++other)
      if (const double like = likeness(found, found.pockets[own], found.pockets[other]); like > 0.0)
        pairs.emplace_back(-like, own, other);
  std::sort(pairs.begin(), pairs.end());
  std::set<int> taken;
  for (const auto& [like, own, other] : pairs) {
    const int wanted = found.pockets[other].number;
    if (found.pockets[own].number == 0 && taken.insert(wanted).second)
      found.pockets[own].number = wanted;
  }
  for (std::size_t own = first; own < found.pockets.size(); ++own)
    if (found.pockets[own].number == 0)
      found.pockets[own].number = ++highest;
}

}  // namespace

std::vector<std::string> ScenePockets::lining(const ScenePocket& pocket) const {
  std::vector<std::string> names;
  names.reserve(pocket.pocket.residues.size());
  for (const std::uint32_t residue : pocket.pocket.residues)
    names.push_back(molecules[pocket.molecule].residues[residue]);
  return names;
}

std::vector<PocketMolecule> moleculesIn(const Scene& scene) {
  std::vector<PocketMolecule> molecules;
  for (const Node& node : scene.nodes()) {
    if (!node.mesh || !node.atoms.set || node.atoms.set->atoms.empty() ||
        !node.style.visible.value_or(true))
      continue;
    auto own = std::find_if(molecules.begin(), molecules.end(),
                            [&](const PocketMolecule& m) { return m.group == node.parent; });
    if (own == molecules.end()) {
      const Node* group = scene.find(node.parent);
      own = molecules.insert(own, {.group = node.parent,
                                   .name = group ? group->name : node.name,
                                   .chains = {},
                                   .residues = {},
                                   .grid = {}});
    }
    own->chains.push_back(node.id);
    const std::vector<std::string>& residues = node.atoms.set->residues;
    own->residues.insert(own->residues.end(), residues.begin(), residues.end());
  }
  return molecules;
}

Result<ScenePockets> pocketsIn(const Scene& scene, const PocketOptions& options,
                               const GoesOn& goesOn) {
  ScenePockets found{moleculesIn(scene), {}};
  if (found.molecules.empty())
    return Error{.file = {},
                 .where = {},
                 .reason = "no structure of the scene keeps the atoms between which pockets are",
                 .remedy = "Import a protein of at most " + std::to_string(mostKeptAtoms) +
                           " atoms from its PDB or mmCIF file"};
  int highest = 0;
  for (std::size_t m = 0; m < found.molecules.size(); ++m) {
    Pockets own = TRY(findPockets(atomsOf(scene, found.molecules[m]), options, goesOn));
    found.molecules[m].grid = own.grid;
    const std::size_t first = found.pockets.size();
    for (Pocket& pocket : own.list) {
      std::vector<NodeId> guests = guestsOf(scene, own.grid, pocket);
      found.pockets.push_back({0, m, std::move(pocket), std::move(guests)});
    }
    number(found, first, highest);
  }
  std::stable_sort(found.pockets.begin(), found.pockets.end(),
                   [](const ScenePocket& a, const ScenePocket& b) { return a.number < b.number; });
  return found;
}

}  // namespace sline::model
