// SPDX-License-Identifier: Apache-2.0
// Lines of PDB and mmCIF files as tests write them, and what tests ask of a closed surface.
#pragma once

#include <QByteArray>
#include <QTemporaryDir>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "model/import/molecules/entry_files.h"
#include "model/import/molecules/surface/lattice_mesh.h"

namespace sline::test {

/// One atom of a written file.
struct Written {
  const char* name = " CA ";  ///< the four columns
  const char* residue = "ALA";
  const char* chain = "A";
  int number = 1;
  glm::dvec3 place{0.0, 0.0, 0.0};
  const char* element = "C";
  bool hetero = false;
  char alternate = ' ';
  double occupancy = 1.0;
  char insertion = ' ';
};

/// An ATOM or HETATM record of 80 columns with its line end.
QByteArray pdbLine(const Written& atom, int serial = 1);
/// All of them, numbered, as a PDB file.
QByteArray pdbFile(std::span<const Written> atoms);
/// The same as the atoms of an mmCIF file.
QByteArray cifFile(std::span<const Written> atoms);
/// And as mmJSON.
QByteArray jsonFile(std::span<const Written> atoms);

/// A peptide of that sequence: backbone atoms and Cβ along an ideal helix.
std::vector<Written> helix(const std::string& letters, const char* chain = "A");

/// Writes the bytes and reads them as records.
Result<model::EntryRecords> recordsOf(const QTemporaryDir& folder, const char* extension,
                                      const QByteArray& bytes);

/// Each edge has exactly one triangle on either side, and they agree.
bool isClosed(const model::TriangleMesh& mesh);
double areaOf(const model::TriangleMesh& mesh);
/// Positive where triangles face outward.
double volumeOf(const model::TriangleMesh& mesh);

/// A whole file; empty where there is none.
QByteArray bytesOf(const char* path);

}  // namespace sline::test
