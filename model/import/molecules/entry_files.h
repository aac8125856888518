// SPDX-License-Identifier: Apache-2.0
// Reads the files of the Protein Data Bank into records.
#pragma once

#include "model/base/result.h"
#include "model/import/molecules/molecule.h"
#include "model/import/source/source.h"

namespace sline::model {

/// Reads the PDB format, version 3.3 and the variants of older and other programs: serials and
/// residue numbers that wrap or go on in hybrid-36, missing element columns, short lines.
Result<EntryRecords> readPdbRecords(const Source& source);

/// Reads PDBx/mmCIF. Chains, residue numbers and atom names are the authors' (auth_…), as people
/// know them. Text that is no CIF ends the reading; everything before it is read.
Result<EntryRecords> readMmcifRecords(const Source& source);
/// Reads an entry in JSON, as the Protein Data Bank Japan publishes it.
Result<EntryRecords> readMmjsonRecords(const Source& source);

/// Judges how many atoms could not be read; returns an error where there are too many to draw the
/// rest.
Status judgeAtoms(const Source& source, const EntryRecords& records);

/// Returns words in capitals as people write them: "CRYSTAL STRUCTURE OF C-SRC" → "Crystal
/// structure of C-SRC". Text that has lower case is left alone, except for blanks.
std::string readableCapitals(std::string_view text);

/// Replaces bytes that are not ASCII by '?', because the formats are ASCII; so names may stand
/// anywhere.
std::string asciiOf(std::string_view text);

/// Returns "C" for "CA" in an amino acid, "Ca" for "CA" in the ion of that name, "K" for the ion
/// that a force field calls POT: elsewhere by the PDB's rule that a one-letter symbol stands in the
/// second column.
const Element* elementOfName(std::string_view columns, std::string_view residue);

}  // namespace sline::model
