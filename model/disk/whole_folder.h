// SPDX-License-Identifier: Apache-2.0
// Folders that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>

#include "model/base/result.h"

namespace sline::model {

/// Lets write(temporary) fill an empty folder beside `folder` and puts it in its place when that
/// succeeded; else nothing is left. What is there already must be an empty folder: nobody's files
/// are mixed with ours, or lost.
Status writeFolder(const std::filesystem::path& folder,
                   const std::function<Status(const std::filesystem::path&)>& write);

}  // namespace sline::model
