// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace sline::model {

/// Returns the file that `file` refers to as `name`, if it lies in `file`'s folder or below, links
/// followed: a file from outside must not be able to make its reader read any other file.
std::optional<std::filesystem::path> fileInFolder(const std::filesystem::path& file,
                                                  std::string_view name);

}  // namespace sline::model
