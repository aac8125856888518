// SPDX-License-Identifier: Apache-2.0
#include "model/import/molecules/molecule_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/import/molecules/ball_and_stick.h"
#include "model/import/molecules/surface/excluded_surface.h"
#include "model/import/molecules/surface/pocket_lining.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

constexpr double finest = 0.75;   ///< Å: edges of about half an ångström
constexpr double coarsest = 4.0;  ///< Å: beyond it single atoms slip through the lattice
constexpr double finestOfLigand = 0.45;
constexpr double trianglesPerSquare = 6.0;
constexpr double chainTriangles = 2e6;
constexpr double ligandTriangles = 5e5;
constexpr std::size_t mostLigands = 60;
constexpr std::size_t mostWithSurface = 5000;  ///< atoms in a ligand
/// Smaller molecules, such as those of a crystal's buffer, rarely have a pocket.
constexpr std::size_t fewestWithPocket = 7;  ///< atoms in a ligand
constexpr std::size_t mostPockets = 12;
/// What lies nearer than this to a ligand's atoms, in ångström, lines its pocket: some two of van
/// der Waals' radii and a little more.
constexpr float pocketReach = 6.0f;
constexpr Colour pocketColour{226, 198, 138};
constexpr const char* tooClose = "its atoms lie closer together than those of matter do";
constexpr std::size_t longestTitle = 90;

constexpr Colour chainColours[] = {{136, 204, 238}, {204, 102, 119}, {221, 204, 119},
                                   {68, 170, 153},  {170, 68, 153},  {17, 119, 51},
                                   {51, 34, 136},   {153, 153, 51},  {136, 34, 85}};
constexpr Colour bondColours[] = {{112, 112, 112}, {62, 128, 96},  {176, 140, 40},
                                  {150, 84, 140},  {52, 124, 160}, {166, 92, 62}};

std::uint8_t mixed(std::uint8_t from, int to, int percent) {
  return std::uint8_t((int(from) * (100 - percent) + to * percent) / 100);
}

std::string pluralised(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Returns the residue's atom in a backbone; nothing for a residue without one (a cap, a lone
/// atom).
const Atom* backboneAtom(const Residue& residue, bool nucleic) {
  for (const std::string_view wanted : nucleic ? std::array<std::string_view, 3>{"P", "C4'", "C4*"}
                                               : std::array<std::string_view, 3>{"CA", "", ""})
    for (const Atom& atom : residue.atoms)
      if (!wanted.empty() && atom.name == wanted)
        return &atom;
  return nullptr;
}

Backbone backboneOf(const Molecule& molecule, const std::string& entry) {
  Backbone backbone;
  backbone.entry = entry;
  backbone.note = molecule.told;
  for (const Chain& chain : molecule.chains) {
    BackboneChain& own = backbone.chains.emplace_back();
    own.id = chain.id;
    own.nucleic = chain.nucleic;
    for (const Residue& residue : chain.residues)
      if (const Atom* atom = backboneAtom(residue, chain.nucleic)) {
        own.letters += residue.letter;
        own.places.push_back(atom->place);
      }
  }
  return backbone;
}

/// Returns what the element's ion is called: "sodium", "chloride".
std::string ionName(const Element& element) {
  std::string name(element.name);
  constexpr std::string_view halogen = "ine";
  if (name.ends_with(halogen))
    name.replace(name.size() - halogen.size(), halogen.size(), "ide");
  return name;
}

/// Cuts the title between words where it is too long for a tree.
std::string shortened(const std::string& title) {
  if (title.size() <= longestTitle)
    return title;
  const std::size_t space = title.rfind(' ', longestTitle);
  return title.substr(0, space == std::string::npos ? longestTitle : space) + " …";
}

/// Returns the chain's atoms as they are kept with its surface.
KeptAtoms keptAtoms(const Chain& chain) {
  auto set = std::make_shared<AtomSet>();
  for (const Residue& residue : chain.residues) {
    std::string name = residue.name + " " + chain.id + " " + residue.label;
    std::replace(name.begin(), name.end(), '|', '?');
    for (const Atom& atom : residue.atoms)
      set->atoms.push_back(
          {glm::vec3(atom.place), atom.element->vanDerWaals, std::uint32_t(set->residues.size())});
    set->residues.push_back(std::move(name));
  }
  return {std::move(set)};
}

std::size_t chainAtoms(const Molecule& molecule) {
  std::size_t count = 0;
  for (const Chain& chain : molecule.chains)
    for (const Residue& residue : chain.residues)
      count += residue.atoms.size();
  return count;
}

class Surfacer {
 public:
  Surfacer(const Molecule& molecule, const std::string& file, const ReadOptions& options)
      : m_molecule(molecule), m_file(file), m_options(options) {}

  RawMeshes make(const std::string& stem) {
    m_entry = m_molecule.id.empty() ? stem : m_molecule.id;
    if (!m_molecule.assembly.empty())
      m_entry += ", assembly " + m_molecule.assembly;
    m_group = m_entry;
    if (!m_molecule.title.empty())
      m_group += " – " + shortened(m_molecule.title);
    m_backbone = std::make_shared<const Backbone>(backboneOf(m_molecule, m_entry));
    for (const Ligand& ligand : m_molecule.ligands)
      for (const Atom& atom : ligand.atoms)
        m_guests.push_back(atom.place);
    addChains();
    addLigands();
    addIons();
    if (m_molecule.waters > 0)
      warn(pluralised(m_molecule.waters, "water molecule") + " left out");
    if (m_molecule.alternates > 0)
      warn(pluralised(m_molecule.alternates, "atom") +
           " at alternative places left out; the most occupied ones are drawn");
    return std::move(m_result);
  }

 private:
  void warn(std::string reason) { m_result.warnings.push_back({m_file, std::move(reason)}); }

  RawMesh* add(std::string name, TriangleMesh mesh, MoleculeOrigin::Role role) {
    if (mesh.triangles.empty())
      return nullptr;
    RawMesh raw;
    raw.name = std::move(name);
    raw.groups = {m_group};
    raw.positions = std::move(mesh.positions);
    raw.triangles = std::move(mesh.triangles);
    raw.frame = Frame::file;
    raw.frameReason = "a molecule has no left and right";
    raw.unitReason = angstromReason;
    raw.smooth = true;
    raw.molecule = MoleculeOrigin{role, 0, m_backbone};
    m_result.meshes.push_back(std::move(raw));
    return &m_result.meshes.back();
  }

  std::optional<SolventAccessible> accessibleOf(const std::vector<const Atom*>& atoms) const {
    std::vector<Ball> balls;
    balls.reserve(atoms.size());
    for (const Atom* atom : atoms)
      balls.push_back({atom->place, double(atom->element->vanDerWaals) + probeRadius});
    return SolventAccessible::of(std::move(balls), m_options.goesOn);
  }

  static std::vector<const Atom*> atomsOf(const Chain& chain) {
    std::vector<const Atom*> atoms;
    for (const Residue& residue : chain.residues)
      for (const Atom& atom : residue.atoms)
        atoms.push_back(&atom);
    return atoms;
  }

  static std::string chainName(const Chain& chain) {
    const std::string id = chain.id.empty() ? "Chain" : "Chain " + chain.id;
    return chain.name.empty() ? id : id + " – " + chain.name;
  }

  void addChains() {
    std::vector<std::optional<SolventAccessible>> accessible;
    double area = 0.0;
    for (const Chain& chain : m_molecule.chains) {
      if (!m_options.goesOn())
        return;
      accessible.push_back(accessibleOf(atomsOf(chain)));
      if (accessible.back())
        area += accessible.back()->roughArea();
      else
        warn(chainName(chain) + " was left out: " + tooClose);
    }
    const double spacing = std::max(finest, std::sqrt(trianglesPerSquare * area / chainTriangles));
    const bool keeps = chainAtoms(m_molecule) <= mostKeptAtoms;
    for (std::size_t i = 0; i < accessible.size(); ++i) {
      if (!accessible[i])
        continue;
      RawMesh* raw = add(
          chainName(m_molecule.chains[i]),
          excludedSurface(*accessible[i], m_guests, std::min(spacing, coarsest), m_options.goesOn),
          MoleculeOrigin::Role::chain);
      if (!raw) {
        warn(chainName(m_molecule.chains[i]) + " has no surface that can be drawn");
        continue;
      }
      raw->molecule->number = i;
      raw->colour = chainColour(i);
      if (keeps)
        raw->molecule->atoms = keptAtoms(m_molecule.chains[i]);
      accessible[i].reset();
    }
  }

  /// Returns the ligands with names of their own; where there are many, those of one kind together,
  /// and the rest of many kinds too.
  std::vector<Ligand> ligandsToShow() const {
    std::vector<Ligand> ligands;
    for (const Ligand& ligand : m_molecule.ligands)
      if (!ligand.ion)
        ligands.push_back(ligand);
    if (ligands.size() > mostLigands) {
      std::map<std::string, std::size_t> kinds;
      std::vector<Ligand> merged;
      for (Ligand& ligand : ligands) {
        const bool full = merged.size() >= mostLigands && !kinds.contains(ligand.code);
        const std::string key = full ? "" : ligand.code;
        const auto [entry, isNew] = kinds.try_emplace(key, merged.size());
        if (isNew && full)
          merged.push_back({"Other ligands", "", "Others", false, {}});
        else if (isNew)
          merged.push_back({ligand.name, "", ligand.code, false, {}});
        auto& atoms = merged[entry->second].atoms;
        atoms.insert(atoms.end(), ligand.atoms.begin(), ligand.atoms.end());
      }
      return merged;
    }
    std::map<std::string, std::size_t> sameName;
    for (const Ligand& ligand : ligands)
      ++sameName[ligand.name];
    for (Ligand& ligand : ligands)
      if (sameName[ligand.name] > 1)
        ligand.name += " " + ligand.place;
    return ligands;
  }

  void addLigands() {
    for (const Ligand& ligand : ligandsToShow()) {
      if (!m_options.goesOn())
        return;
      std::vector<const Atom*> atoms;
      for (const Atom& atom : ligand.atoms)
        atoms.push_back(&atom);
      const auto accessible = accessibleOf(atoms);
      if (!accessible) {
        warn(ligand.name + " was left out: " + tooClose);
        continue;
      }
      for (ElementSurface& part : ballAndStick(ligand.atoms, m_molecule.bonds, m_options.goesOn)) {
        const std::string name = ligand.code + " " + std::string(part.element->name);
        RawMesh* raw = add(part.withBonds ? name + " and bonds" : name, std::move(part.mesh),
                           part.element->symbol == "C" ? MoleculeOrigin::Role::bonds
                                                       : MoleculeOrigin::Role::other);
        if (!raw)
          continue;
        raw->groups = {m_group, "Ligands", ligand.name};
        raw->colour = part.element->colour;
      }
      if (ligand.atoms.size() <= mostWithSurface) {
        addLigandSurface(ligand, *accessible);
        addPocket(ligand);
      }
    }
  }

  /// Adds what of the chains lines the ligand's pocket, hidden at first as it lies on the chains.
  void addPocket(const Ligand& ligand) {
    if (ligand.atoms.size() < fewestWithPocket || m_pockets >= mostPockets)
      return;
    std::vector<glm::vec3> guest;
    for (const Atom& atom : ligand.atoms)
      guest.emplace_back(atom.place);
    TriangleMesh all;
    for (const RawMesh& mesh : m_result.meshes) {
      if (mesh.molecule->role != MoleculeOrigin::Role::chain)
        continue;
      const TriangleMesh lining =
          pocketLining({mesh.positions, mesh.triangles}, guest, pocketReach);
      const auto first = std::uint32_t(all.positions.size());
      all.positions.insert(all.positions.end(), lining.positions.begin(), lining.positions.end());
      for (const Triangle& t : lining.triangles)
        all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    RawMesh* raw = add(ligand.code + " pocket", std::move(all), MoleculeOrigin::Role::other);
    if (!raw)
      return;
    ++m_pockets;
    raw->groups = {m_group, "Pockets"};
    raw->colour = pocketColour;
    raw->visible = false;
  }

  /// Adds the surface, hidden at first and in a group of its own, so that statements about ligands
  /// do not apply to it.
  void addLigandSurface(const Ligand& ligand, const SolventAccessible& accessible) {
    const double spacing =
        std::clamp(std::sqrt(trianglesPerSquare * accessible.roughArea() / ligandTriangles),
                   finestOfLigand, coarsest);
    RawMesh* raw =
        add(ligand.code + " surface", excludedSurface(accessible, {}, spacing, m_options.goesOn),
            MoleculeOrigin::Role::bonds);
    if (!raw)
      return;
    raw->groups = {m_group, "Ligand surfaces"};
    raw->colour = bondColour(0);
    raw->visible = false;
  }

  void addIons() {
    std::vector<std::pair<std::string, std::vector<Atom>>> kinds;
    for (const Ligand& ligand : m_molecule.ligands) {
      if (!ligand.ion)
        continue;
      const Element& element = *ligand.atoms.front().element;
      const bool unnamed = ligand.name == ligand.code && element.symbol != unknownElement().symbol;
      std::string name = unnamed ? ionName(element) + " (" + ligand.code + ")" : ligand.name;
      const auto named = [&](const auto& kind) { return kind.first == name; };
      if (kinds.size() >= mostLigands && std::none_of(kinds.begin(), kinds.end(), named))
        name = "Other ions";
      auto found = std::find_if(kinds.begin(), kinds.end(), named);
      if (found == kinds.end())
        found = kinds.insert(kinds.end(), {name, {}});
      found->second.push_back(ligand.atoms.front());
    }
    for (const auto& [name, atoms] : kinds) {
      const std::string shown =
          atoms.size() == 1 ? name : name + " × " + std::to_string(atoms.size());
      if (RawMesh* raw = add(shown, balls(atoms, ionShare), MoleculeOrigin::Role::other)) {
        raw->groups.emplace_back("Ions");
        raw->colour = atoms.front().element->colour;
      }
    }
  }

  const Molecule& m_molecule;
  const std::string& m_file;
  const ReadOptions& m_options;
  std::string m_entry;
  std::string m_group;
  std::shared_ptr<const Backbone> m_backbone;
  std::vector<glm::dvec3> m_guests;
  std::size_t m_pockets = 0;
  RawMeshes m_result;
};

}  // namespace

Colour chainColour(std::size_t number) {
  constexpr std::size_t count = std::size(chainColours);
  const Colour c = chainColours[number % count];
  const std::size_t round = number / count % 3;
  if (round == 0)
    return c;
  const int to = round == 1 ? 255 : 0;
  return {mixed(c.red, to, 40), mixed(c.green, to, 40), mixed(c.blue, to, 40)};
}

Colour bondColour(std::size_t entry) {
  return bondColours[entry % std::size(bondColours)];
}

RawMeshes surfacesOf(const Molecule& molecule, const std::string& file, const std::string& stem,
                     const ReadOptions& options) {
  return Surfacer(molecule, file, options).make(stem);
}

}  // namespace sline::model
