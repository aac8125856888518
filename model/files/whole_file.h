// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "model/base/result.h"

namespace sline::model {

/// Lets write(temporary) write a file beside `file` and puts it in its place when that succeeded
/// and the disk has it, so that a full disk, a crash or a power cut leaves the old file or the new
/// one whole. A link keeps pointing to its file, and the file keeps its rights. What exists and is
/// no plain file (a pipe, /dev/stdout) is written directly.
Status writeBeside(const std::filesystem::path& file,
                   const std::function<Status(const std::filesystem::path&)>& write);

/// Any bytes.
Status writeText(const std::filesystem::path& file, std::string_view text);

/// The whole file, or why not; at most `limit` bytes.
Result<std::string> readText(const std::filesystem::path& file, std::size_t limit);

}  // namespace sline::model
