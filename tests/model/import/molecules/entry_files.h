// SPDX-License-Identifier: Apache-2.0
// Writes lines of PDB and mmCIF files for the tests, and measures closed surfaces.
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

/// Holds one atom of a written file.
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

/// Returns an ATOM or HETATM record of 80 columns with its line end.
QByteArray pdbLine(const Written& atom, int serial = 1);
/// Returns all atoms, numbered, as a PDB file.
QByteArray pdbFile(std::span<const Written> atoms);
/// Returns the atoms as an mmCIF file.
QByteArray cifFile(std::span<const Written> atoms);
/// Returns the atoms as mmJSON.
QByteArray jsonFile(std::span<const Written> atoms);

/// Returns a peptide of that sequence: backbone atoms and Cβ along an ideal helix.
std::vector<Written> helix(const std::string& letters, const char* chain = "A");

/// Writes the bytes and reads them as records.
Result<model::EntryRecords> recordsOf(const QTemporaryDir& folder, const char* extension,
                                      const QByteArray& bytes);

/// Tells whether each edge has exactly one triangle on either side, and the two agree in direction.
bool isClosed(const model::TriangleMesh& mesh);
double areaOf(const model::TriangleMesh& mesh);
/// Returns the volume; positive if triangles face outward.
double volumeOf(const model::TriangleMesh& mesh);

/// Returns a whole file; empty if there is none.
QByteArray bytesOf(const char* path);

}  // namespace sline::test
