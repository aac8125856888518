// SPDX-License-Identifier: Apache-2.0
// A molecule → the surfaces that stand for it in a scene.
#pragma once

#include <memory>
#include <string>

#include "model/import/molecules/molecule.h"
#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Colours of chains that colour-blind people can tell apart (Tol's "muted" scheme), lighter and
/// darker after nine.
Colour chainColour(std::size_t number);

/// The bonds' and carbons' colour in the ligands of the first, second, … entry of a scene.
Colour bondColour(std::size_t entry);

/// One excluded surface for each chain; for each ligand balls and sticks by element and a hidden
/// excluded surface; balls for each kind of ion. Enclosed in groups: the entry, in it "Ligands" and
/// "Ions". `file` is named in warnings, `stem` stands in for a missing name.
RawMeshes surfacesOf(const Molecule& molecule, const std::string& file, const std::string& stem,
                     const ReadOptions& options);

}  // namespace sline::model
