// SPDX-License-Identifier: Apache-2.0
// Finds in names of files and folders of which body they are: of a woman or of a man, of which
// patient.
#pragma once

#include <string>
#include <string_view>

namespace sline::model {

/// Returns the sex that a name says, "f" or "m": a word for it in one of the languages of names
/// ("female", "Frau"), or F or M behind a word for a body, as sets of models are numbered
/// ("VH_F_Heart", "patient-m"). A name that says both says none.
std::string sexInName(std::string_view name);

/// Returns the number of a patient, subject or case that a name has, without zeros before it:
/// "12" of "patient012_liver".
std::string numberInName(std::string_view name);

}  // namespace sline::model
