// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/residues.h"

#include <algorithm>
#include <gemmi/resinfo.hpp>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <optional>
#include <string_view>

namespace sline::model {

namespace {

struct Alias {
  std::string_view name;
  const char* tabulated;
};

/// Maps the names that force fields and old files give residues which gemmi tabulates under one
/// name.
constexpr Alias aliases[] = {{"HID", "HIS"},  {"HIE", "HIS"}, {"HIP", "HIS"},  {"HSD", "HIS"},
                             {"HSE", "HIS"},  {"HSP", "HIS"}, {"CYX", "CYS"},  {"T", "DT"},
                             {"ADE", "A"},    {"CYT", "C"},   {"GUA", "G"},    {"THY", "DT"},
                             {"URA", "U"},    {"TIP", "HOH"}, {"TIP3", "HOH"}, {"TIP4", "HOH"},
                             {"TIP5", "HOH"}, {"SOL", "HOH"}, {"SPC", "HOH"}};

gemmi::ResidueInfo infoOf(std::string_view residue) {
  const auto* const alias = std::find_if(std::begin(aliases), std::end(aliases),
                                         [&](const Alias& a) { return a.name == residue; });
  return gemmi::find_tabulated_residue(alias == std::end(aliases) ? std::string(residue)
                                                                  : alias->tabulated);
}

bool isOfChains(const gemmi::ResidueInfo& info) {
  return info.is_amino_acid() || info.is_nucleic_acid();
}

struct CommonName {
  std::string_view code;
  std::string_view name;
};

/// Lists common names; the data bank's own names are those of chemistry.
constexpr CommonName commonNames[] = {{"ACP", "AMP-PCP"},
                                      {"ADP", "ADP"},
                                      {"AMP", "AMP"},
                                      {"ANP", "AMP-PNP"},
                                      {"ATP", "ATP"},
                                      {"BEN", "Benzamidine"},
                                      {"CLA", "Chlorophyll a"},
                                      {"CLR", "Cholesterol"},
                                      {"COA", "Coenzyme A"},
                                      {"EDO", "Ethylene glycol"},
                                      {"FAD", "FAD"},
                                      {"FMN", "FMN"},
                                      {"GDP", "GDP"},
                                      {"GNP", "GMP-PNP"},
                                      {"GOL", "Glycerol"},
                                      {"GTP", "GTP"},
                                      {"HEC", "Haem c"},
                                      {"HEM", "Haem b"},
                                      {"NAD", "NAD"},
                                      {"NAP", "NADP"},
                                      {"NDP", "NADPH"},
                                      {"PLP", "Pyridoxal phosphate"},
                                      {"PO4", "Phosphate"},
                                      {"RET", "Retinal"},
                                      {"SAH", "S-adenosylhomocysteine"},
                                      {"SAM", "S-adenosylmethionine"},
                                      {"SO4", "Sulphate"},
                                      {"STI", "Imatinib"}};

enum class Kind { polymer, ligand, water };

/// Holds one residue with the data that sorting it needs.
struct Group {
  Residue residue;
  std::string chain;
  std::string entity;
  bool hetero = false;
  bool afterEnd = false;
  Kind kind = Kind::ligand;
};

const Atom* atomNamed(const Residue& residue, std::string_view name) {
  const auto found = std::find_if(residue.atoms.begin(), residue.atoms.end(),
                                  [&](const Atom& atom) { return atom.name == name; });
  return found == residue.atoms.end() ? nullptr : &*found;
}

bool areNear(const Atom* a, const Atom* b, double limit) {
  return a && b && glm::length(a->place - b->place) < limit;
}

/// Tells whether one residue's backbone is bonded to the next: peptide or phosphodiester.
bool areJoined(const Residue& first, const Residue& second) {
  return areNear(atomNamed(first, "C"), atomNamed(second, "N"), 1.9) ||
         areNear(atomNamed(first, "O3'"), atomNamed(second, "P"), 2.2) ||
         areNear(atomNamed(first, "O3*"), atomNamed(second, "P"), 2.2);
}

bool hasBackbone(const Residue& residue) {
  const auto has = [&](std::string_view name) { return atomNamed(residue, name) != nullptr; };
  return (has("N") && has("CA") && has("C")) ||
         ((has("C1'") || has("C1*")) && (has("C4'") || has("C4*")));
}

class Sorter {
 public:
  explicit Sorter(EntryRecords records) : m_records(std::move(records)) {}

  Molecule sort() {
    m_molecule.id = m_records.notes.id;
    m_molecule.title = m_records.notes.title;
    m_molecule.assembly = m_records.notes.assembly;
    m_molecule.told = m_records.notes.told;
    m_molecule.bonds = m_records.notes.bonds;
    gather();
    for (std::size_t i = 0; i < m_groups.size(); ++i)
      m_groups[i].kind = kindOf(i);
    addChains();
    addLigands();
    return std::move(m_molecule);
  }

 private:
  /// Gathers records into residues: those in a run with the same chain and number are one.
  void gather() {
    const std::vector<AtomRecord>& atoms = m_records.atoms;
    for (std::size_t first = 0; first < atoms.size();) {
      const auto same = [&](const AtomRecord& a) {
        const AtomRecord& b = atoms[first];
        const bool alternative = a.alternate != ' ' && b.alternate != ' ';
        return a.chain == b.chain && a.number == b.number && a.insertion == b.insertion &&
               (a.residue == b.residue || alternative);
      };
      std::size_t last = first + 1;
      while (last < atoms.size() && same(atoms[last]))
        ++last;
      m_groups.push_back(groupOf(std::span(atoms).subspan(first, last - first)));
      first = last;
    }
  }

  Group groupOf(std::span<const AtomRecord> records) {
    std::map<char, float> occupied;
    for (const AtomRecord& atom : records)
      if (atom.alternate != ' ')
        occupied[atom.alternate] += atom.occupancy;
    const auto most =
        std::max_element(occupied.begin(), occupied.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    Group group;
    std::set<std::string_view> names;
    for (const AtomRecord& atom : records) {
      const bool chosen = atom.alternate == ' ' || atom.alternate == most->first;
      if (!chosen || (!occupied.empty() && !names.insert(atom.name).second)) {
        ++m_molecule.alternates;
        continue;
      }
      if (group.residue.atoms.empty()) {
        group.residue.name = atom.residue;
        group.residue.label = std::to_string(atom.number) + atom.insertion;
        group.residue.letter = letterOf(atom.residue);
        group.chain = atom.chain;
        group.entity = atom.entity;
        group.hetero = atom.hetero;
        group.afterEnd = atom.afterEnd;
      }
      group.residue.atoms.push_back({atom.name, atom.element, atom.place, atom.serial});
    }
    if (group.residue.letter == 'X')
      if (const auto parent = m_records.notes.parents.find(group.residue.name);
          parent != m_records.notes.parents.end())
        group.residue.letter = letterOf(parent->second);
    return group;
  }

  Kind kindOf(std::size_t i) const {
    const Group& group = m_groups[i];
    const auto type = m_records.notes.entityTypes.find(group.entity);
    if (!group.entity.empty() && type != m_records.notes.entityTypes.end())
      return type->second == "polymer" ? Kind::polymer
             : type->second == "water" ? Kind::water
                                       : Kind::ligand;
    const gemmi::ResidueInfo info = infoOf(group.residue.name);
    if (info.is_water())
      return Kind::water;
    if (!group.hetero && (isOfChains(info) || hasBackbone(group.residue)))
      return Kind::polymer;
    return isBondedIn(i) ? Kind::polymer : Kind::ligand;
  }

  /// Tells whether the residue is joined to the one before or behind it in its chain.
  bool isBondedIn(std::size_t i) const {
    const Group& group = m_groups[i];
    const auto joined = [&](std::size_t a, std::size_t b) {
      return m_groups[a].chain == m_groups[b].chain &&
             areJoined(m_groups[a].residue, m_groups[b].residue);
    };
    if ((i > 0 && joined(i - 1, i)) || (i + 1 < m_groups.size() && joined(i, i + 1)))
      return true;
    // It is known to be a modified residue; its neighbours may not have been seen.
    return !group.afterEnd && m_records.notes.parents.contains(group.residue.name) &&
           hasBackbone(group.residue);
  }

  void addChains() {
    std::map<std::string, std::size_t> numbers;
    for (Group& group : m_groups) {
      if (group.kind == Kind::water)
        ++m_molecule.waters;
      if (group.kind != Kind::polymer)
        continue;
      const auto [entry, isNew] = numbers.try_emplace(group.chain, m_molecule.chains.size());
      if (isNew) {
        const auto name = m_records.notes.chainNames.find(group.chain);
        m_molecule.chains.push_back(
            {group.chain, name == m_records.notes.chainNames.end() ? "" : name->second, false, {}});
      }
      m_molecule.chains[entry->second].residues.push_back(std::move(group.residue));
    }
    for (Chain& chain : m_molecule.chains) {
      const auto bases =
          std::count_if(chain.residues.begin(), chain.residues.end(), [](const Residue& residue) {
            const gemmi::ResidueInfo info = infoOf(residue.name);
            return isOfChains(info) ? info.is_nucleic_acid() : !atomNamed(residue, "CA");
          });
      chain.nucleic = 2 * std::size_t(bases) > chain.residues.size();
    }
  }

  void addLigands() {
    std::vector<std::size_t> groups;
    std::vector<Atom> atoms;
    std::vector<std::size_t> ownerOf;
    for (std::size_t i = 0; i < m_groups.size(); ++i) {
      if (m_groups[i].kind != Kind::ligand)
        continue;
      const auto& own = m_groups[i].residue.atoms;
      atoms.insert(atoms.end(), own.begin(), own.end());
      ownerOf.insert(ownerOf.end(), own.size(), groups.size());
      groups.push_back(i);
    }
    std::vector<std::size_t> parent(groups.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    const auto rootOf = [&](std::size_t g) {
      while (parent[g] != g)
        g = parent[g] = parent[parent[g]];
      return g;
    };
    const auto isIon = [&](std::size_t g) { return m_groups[groups[g]].residue.atoms.size() == 1; };
    for (const auto& [a, b] : bondsBetween(atoms, {}))
      if (!isIon(ownerOf[a]) && !isIon(ownerOf[b])) {
        const auto [low, high] = std::minmax({rootOf(ownerOf[a]), rootOf(ownerOf[b])});
        parent[high] = low;
      }
    std::map<std::size_t, std::vector<std::size_t>> members;
    for (std::size_t g = 0; g < groups.size(); ++g)
      members[rootOf(g)].push_back(groups[g]);
    for (const auto& [root, list] : members)
      addLigand(list);
  }

  void addLigand(const std::vector<std::size_t>& members) {
    const Group& first = m_groups[members.front()];
    Ligand ligand;
    ligand.place = (first.chain.empty() ? "" : first.chain + " ") + first.residue.label;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const Residue& residue = m_groups[members[i]].residue;
      if (i < 4)
        ligand.code += (i == 0 ? "" : "-") + residue.name;
      else if (i == 4)
        ligand.code += "-…";
      ligand.atoms.insert(ligand.atoms.end(), residue.atoms.begin(), residue.atoms.end());
    }
    ligand.ion = ligand.atoms.size() == 1;
    ligand.name = members.size() == 1 ? nameOf(first.residue) : std::string();
    ligand.name = ligand.name.empty() ? ligand.code : ligand.name + " (" + ligand.code + ")";
    m_molecule.ligands.push_back(std::move(ligand));
  }

  std::string nameOf(const Residue& residue) const {
    const std::string& code = residue.name;
    const auto* const common = std::find_if(std::begin(commonNames), std::end(commonNames),
                                            [&](const CommonName& n) { return n.code == code; });
    // A single atom is an ion, whatever molecule has the same code: CHARMM's CLA is a chloride.
    if (common != std::end(commonNames) && residue.atoms.size() > 1)
      return std::string(common->name);
    const auto found = m_records.notes.componentNames.find(code);
    return found == m_records.notes.componentNames.end() ? std::string() : found->second;
  }

  EntryRecords m_records;
  std::vector<Group> m_groups;
  Molecule m_molecule;
};

}  // namespace

char letterOf(std::string_view residue) {
  const gemmi::ResidueInfo info = infoOf(residue);
  const char letter = info.one_letter_code;
  // Modified residues have the letter of the residue they were, in lower case.
  const char capital = letter >= 'a' && letter <= 'z' ? char(letter - 'a' + 'A') : letter;
  if (!isOfChains(info) || capital == ' ' || capital == 'B' || capital == 'Z')
    return 'X';
  // BLOSUM62 knows neither selenocysteine nor pyrrolysine.
  if (info.is_amino_acid() && (capital == 'U' || capital == 'O'))
    return capital == 'U' ? 'C' : 'K';
  return capital;
}

Molecule moleculeOf(EntryRecords records) {
  return Sorter(std::move(records)).sort();
}

}  // namespace sline::model
