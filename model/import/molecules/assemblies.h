// SPDX-License-Identifier: Apache-2.0
// Makes biological assemblies: the atoms in a file are often but one of several equal copies, or
// several molecules that happen to lie in one crystal. The file tells which of its chains, turned
// and moved how often, are the molecule at work.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/import/source/source.h"

namespace sline::model {

struct EntryRecords;

/// Describes the motion x → rotation · x + shift, in ångström.
struct AssemblyOperator {
  glm::dmat3 rotation{1.0};
  glm::dvec3 shift{0.0, 0.0, 0.0};
};

/// Copies the listed parts of the entry once by each operator.
struct AssemblyStep {
  std::vector<std::string> parts;  ///< as AtomRecord::part
  std::string operators;  ///< names as mmCIF lists them: "1,3", "(1-60)", "(X0)(1-5,7)"; the right
                          ///< one of two in a row is applied first
};

struct Assembly {
  std::string id;
  std::string details;  ///< "tetrameric"; may be empty
  std::vector<AssemblyStep> steps;
};

struct Assemblies {
  std::vector<Assembly> all;
  std::map<std::string, AssemblyOperator> operators;
};

/// Returns the assemblies that REMARK 350 of a PDB file describes, from its lines.
Assemblies assembliesOfRemarks(std::string_view lines);

/// Returns the names in a list with commas between them.
std::vector<std::string> namesInList(std::string_view list);

/// Puts the copies that make up the assembly in the place of the entry's atoms. The first copy of a
/// chain keeps its name, others are called "A-2", "A-3" … It is an error where the entry has no
/// such assembly, it is larger than can be drawn, or an operator is no rotation.
Status assemble(const Source& source, EntryRecords& entry, const std::string& id);

/// Returns "describes assembly 1 (2 copies, dimeric)".
std::string assembliesText(const Assemblies& assemblies);

/// Tells whether one of the assemblies has more than one copy, or there are several assemblies.
bool differFromTheirAtoms(const Assemblies& assemblies);

}  // namespace sline::model
