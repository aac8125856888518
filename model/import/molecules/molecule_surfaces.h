// SPDX-License-Identifier: Apache-2.0
// Turns a molecule into the surfaces that stand for it in a scene.
#pragma once

#include <memory>
#include <string>

#include "model/import/molecules/molecule.h"
#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Returns colours for chains that colour-blind people can tell apart (Tol's "muted" scheme),
/// lighter and darker after nine.
Colour chainColour(std::size_t number);

/// Returns the colour of bonds and carbons in the ligands of the first, second, … entry of a scene.
Colour bondColour(std::size_t entry);

/// Returns one excluded surface for each chain; for each ligand balls and sticks by element, a
/// hidden excluded surface and, hidden too, the part of the chains' surfaces that lines its pocket;
/// and balls for each kind of ion. They are enclosed in groups: the entry, and in it "Ligands",
/// "Ligand surfaces", "Pockets" and "Ions". `file` is named in warnings, `stem` stands in for a
/// missing name.
RawMeshes surfacesOf(const Molecule& molecule, const std::string& file, const std::string& stem,
                     const ReadOptions& options);

}  // namespace sline::model
