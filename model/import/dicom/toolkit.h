// SPDX-License-Identifier: Apache-2.0
// DCMTK as it is used here: silent, with decoders, and with a dictionary of its own.
#pragma once

namespace sline::model {

/// Must have been called before anything of DCMTK reads; does its work once.
void setUpToolkit();

/// A part of it: the dictionary is nothing but the elements whose kind has to be known where a file
/// leaves it out (tag.h). So no file of DCMTK's is needed at run time, and what no one asks for is
/// not even interpreted.
void useOwnDictionary();

}  // namespace sline::model
