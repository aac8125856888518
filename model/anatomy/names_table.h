// SPDX-License-Identifier: Apache-2.0
// Holds resources/anatomy/names.tsv, compiled in so that the program needs no folder at run time.
#pragma once

#include <string_view>

namespace sline::model {

std::string_view anatomicalNamesText();

}  // namespace sline::model
