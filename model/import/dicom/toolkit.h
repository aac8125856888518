// SPDX-License-Identifier: Apache-2.0
// Sets up DCMTK as it is used here: silent, with decoders, and with a dictionary of its own.
#pragma once

namespace sline::model {

/// Sets up DCMTK; must be called before any part of DCMTK reads. It does its work once.
void setUpToolkit();

/// Replaces DCMTK's dictionary (a part of setUpToolkit) by one of just the elements for which the
/// kind has to be known where a file leaves it out (tag.h). So no file of DCMTK's is needed at run
/// time, and elements that are never asked for are not even interpreted.
void useOwnDictionary();

}  // namespace sline::model
