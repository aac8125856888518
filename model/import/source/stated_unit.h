// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace sline::model {

/// Returns how many millimetres the unit has that a file's header states, going by what its reader
/// says of it (RawMesh::unitReason, "header: micrometres"); 1 where that names no other length.
constexpr double statedMillimetres(std::string_view unitReason) {
  constexpr std::array<std::pair<std::string_view, double>, 3> stated{
      {{"header: metres", 1000.0}, {"header: centimetres", 10.0}, {"header: micrometres", 0.001}}};
  for (const auto& [text, millimetres] : stated)
    if (unitReason.starts_with(text))
      return millimetres;
  return 1.0;
}

}  // namespace sline::model
