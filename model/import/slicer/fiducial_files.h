// SPDX-License-Identifier: Apache-2.0
// Reads the two formats of fiducials from text in memory (private to model/import/fiducials).
#pragma once

#include <string_view>

#include "model/import/slicer/fiducials.h"

namespace sline::model {

/// Reads .fcsv; `file` is for messages.
Result<Fiducials> fiducialsInTable(std::string_view text, const std::filesystem::path& file);
/// Reads .mrk.json; `name` is the name given to a line without one of its own.
Result<Fiducials> fiducialsInMarkups(std::string_view text, const std::filesystem::path& file,
                                     const std::string& name);

}  // namespace sline::model
