// SPDX-License-Identifier: Apache-2.0
// Represents a macromolecular entry as its file describes it: atoms in residues in chains, and the
// molecules bound to them. Coordinates are in ångström, as they stand in the file.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/import/molecules/assemblies.h"
#include "model/import/molecules/elements.h"

namespace sline::model {

/// Holds one line of a file's atom list.
struct AtomRecord {
  std::string name;     ///< "CA"
  std::string residue;  ///< "GLY"
  std::string chain;
  std::string part;    ///< chain of which assemblies are made; in mmCIF the data bank's own
  std::string entity;  ///< mmCIF: its id in the list of entities; else empty
  std::string insertion;
  std::int64_t number = 0;  ///< number of the residue
  std::int64_t serial = 0;
  char alternate = ' ';
  bool hetero = false;
  bool afterEnd = false;  ///< PDB: behind its chain's TER
  float occupancy = 1.0f;
  glm::dvec3 place{0.0, 0.0, 0.0};
  const Element* element = nullptr;  ///< never null once read
};

/// Holds what a file says besides its atoms. Ids are those of the atoms' records.
struct EntryNotes {
  std::string id;  ///< "2SRC"
  std::string title;
  std::string assembly;  ///< the assembly that the atoms make up; empty: they are as in the file
  std::string told;      ///< as Backbone::note
  std::map<std::string, std::string> chainNames;      ///< by chain
  std::map<std::string, std::string> componentNames;  ///< by residue name
  std::map<std::string, std::string> entityTypes;     ///< mmCIF: "polymer", "water", …
  std::map<std::string, std::string> parents;  ///< modified residue → the residue it was: PTR → TYR
  std::set<std::pair<std::int64_t, std::int64_t>> bonds;  ///< by serial, lower first
};

/// Holds an entry before alternates are chosen and residues sorted.
struct EntryRecords {
  std::vector<AtomRecord> atoms;  ///< those of the first model
  EntryNotes notes;
  Assemblies assemblies;
  std::string cutShort;  ///< where and why reading the file ended early
  std::size_t otherModels = 0;
  std::size_t unreadable = 0;  ///< atoms without a place
};

struct Atom {
  std::string name;
  const Element* element = nullptr;
  glm::dvec3 place{0.0, 0.0, 0.0};
  std::int64_t serial = 0;
};

struct Residue {
  std::string name;
  std::string label;  ///< number and insertion code: "52A"
  char letter = 'X';  ///< one-letter code of an amino acid or base; X: none
  std::vector<Atom> atoms;
};

struct Chain {
  std::string id;
  std::string name;  ///< "Tyrosine-protein kinase Src"; may be empty
  bool nucleic = false;
  std::vector<Residue> residues;
};

/// Describes one bound molecule: a residue that is part of no chain, or several bonded to each
/// other.
struct Ligand {
  std::string name;   ///< "AMP-PNP (ANP)"
  std::string place;  ///< "A 147"
  std::string code;   ///< "ANP"
  bool ion = false;   ///< a single atom
  std::vector<Atom> atoms;
};

struct Molecule {
  std::string id;
  std::string title;     ///< may be empty
  std::string assembly;  ///< as in EntryNotes
  std::string told;      ///< as in EntryNotes
  std::vector<Chain> chains;
  std::vector<Ligand> ligands;
  std::set<std::pair<std::int64_t, std::int64_t>> bonds;
  std::size_t waters = 0;
  std::size_t alternates = 0;  ///< atoms left out in favour of an alternative
};

}  // namespace sline::model
