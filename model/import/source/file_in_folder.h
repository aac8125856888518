// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace sline::model {

/// The file that `file` refers to as `name`, if it lies in `file`'s folder or below, links
/// followed: what comes from outside must not be able to read any other file of its reader.
std::optional<std::filesystem::path> fileInFolder(const std::filesystem::path& file,
                                                  std::string_view name);

}  // namespace sline::model
