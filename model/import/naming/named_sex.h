// SPDX-License-Identifier: Apache-2.0
// Finds in names of files and folders whether they are of a woman or of a man.
#pragma once

#include <string_view>

namespace sline::model {

enum class NamedSex { none, female, male };

/// Returns the sex that a name says: a word for it in one of the languages of names ("female",
/// "Frau"), or F or M behind a word for a body, as sets of models are numbered ("VH_F_Heart",
/// "patient-m"). A name that says both says none.
NamedSex sexInName(std::string_view name);

}  // namespace sline::model
