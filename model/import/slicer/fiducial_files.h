// SPDX-License-Identifier: Apache-2.0
// The two formats of fiducials, from text in memory (private to model/import/fiducials).
#pragma once

#include <string_view>

#include "model/import/slicer/fiducials.h"

namespace sline::model {

/// .fcsv; `file` is for messages.
Result<Fiducials> fiducialsInTable(std::string_view text, const std::filesystem::path& file);
/// .mrk.json; `name` is what a line without a name of its own is called.
Result<Fiducials> fiducialsInMarkups(std::string_view text, const std::filesystem::path& file,
                                     const std::string& name);

}  // namespace sline::model
