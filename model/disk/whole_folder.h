// SPDX-License-Identifier: Apache-2.0
// Writes folders that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>

#include "model/base/result.h"

namespace sline::model {

/// Lets write(temporary) fill an empty folder beside `folder` and puts it in its place when that
/// succeeded; else nothing is left. An existing folder must be empty, so that no other files are
/// mixed with the new ones, or lost.
Status writeFolder(const std::filesystem::path& folder,
                   const std::function<Status(const std::filesystem::path&)>& write);

}  // namespace sline::model
