// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace sline::model {

/// Returns the folder of the user's system for files that a program can make again:
/// $XDG_CACHE_HOME/sline, else ~/.cache/sline (XDG Base Directory Specification: a relative
/// XDG_CACHE_HOME counts as none). Empty where neither is known. The folder need not exist.
std::filesystem::path userCacheFolder();

/// Returns the folder for files that a program must find again after a restart:
/// $XDG_STATE_HOME/sline, else ~/.local/state/sline.
std::filesystem::path userStateFolder();

}  // namespace sline::model
