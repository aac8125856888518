// SPDX-License-Identifier: Apache-2.0
// Holds the texts of resources/anatomy, compiled in so that the program needs no folder at run
// time.
#pragma once

#include <string_view>

namespace sline::model {

std::string_view anatomySystemsText();
std::string_view anatomyStructuresText();
std::string_view tissuePatternsText();
std::string_view supplyText();
std::string_view sizesText();

}  // namespace sline::model
