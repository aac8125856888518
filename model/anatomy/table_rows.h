// SPDX-License-Identifier: Apache-2.0
// Takes the tables of resources/anatomy apart.
#pragma once

#include <string_view>
#include <vector>

namespace sline::model {

/// Returns the parts of a text between separators; a text without one is a part.
std::vector<std::string_view> cutAt(std::string_view text, char separator);

/// Returns the fields between tabs of each row. Empty lines and those that begin with "# " are
/// remarks. The text must outlive the result.
std::vector<std::vector<std::string_view>> tableRows(std::string_view text);

}  // namespace sline::model
