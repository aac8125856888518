// SPDX-License-Identifier: Apache-2.0
// Holds resources/anatomy/names.tsv and cells.tsv, compiled in so that the program needs no folder
// at run time.
#pragma once

#include <string_view>

namespace sline::model {

std::string_view anatomicalNamesText();
std::string_view cellNamesText();

}  // namespace sline::model
