// SPDX-License-Identifier: Apache-2.0
// The files of the Protein Data Bank → the records in them.
#pragma once

#include "model/base/result.h"
#include "model/import/molecules/molecule.h"
#include "model/import/source/source.h"

namespace sline::model {

/// PDB format, version 3.3 and what older and other programs make of it: serials and residue
/// numbers that wrap or go on in hybrid-36, missing element columns, short lines.
Result<EntryRecords> readPdbRecords(const Source& source);

/// PDBx/mmCIF. Chains, residue numbers and atom names are the authors' (auth_…), as people know
/// them. Text that is no CIF ends the reading, with what stands before it read.
Result<EntryRecords> readMmcifRecords(const Source& source);
/// The same in JSON, as the Protein Data Bank Japan hands it out.
Result<EntryRecords> readMmjsonRecords(const Source& source);

/// Judges how many atoms could not be read: an error where there are too many to draw the rest.
Status judgeAtoms(const Source& source, const EntryRecords& records);

/// Words in capitals as people write them: "CRYSTAL STRUCTURE OF C-SRC" → "Crystal structure of
/// C-SRC". Text that has lower case is left alone, but for blanks.
std::string readableCapitals(std::string_view text);

/// The formats are ASCII: other bytes become '?', so that names may stand anywhere.
std::string asciiOf(std::string_view text);

/// "C" of "CA" in an amino acid, "Ca" of "CA" in the ion of that name; by the PDB's rule that one
/// letter stands in the second column.
const Element* elementOfName(std::string_view columns, std::string_view residue);

}  // namespace sline::model
