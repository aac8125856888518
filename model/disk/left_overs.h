// SPDX-License-Identifier: Apache-2.0
// Names what is written before it is put in its place, and removes what killed writers have left of
// that.
#pragma once

#include <filesystem>

namespace sline::model {

/// Returns the path beside the file or folder under which this process writes it:
/// ".NAME.4711.part". With a number the name is another one: ".NAME.4711-2.part".
std::filesystem::path partBeside(const std::filesystem::path& named, int number = 0);

/// Removes parts beside the file or folder whose writers no longer run.
void removeLeftOvers(const std::filesystem::path& named);

}  // namespace sline::model
