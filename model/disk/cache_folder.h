// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace sline::model {

/// Where the user's system keeps what a program can make again: $XDG_CACHE_HOME/sline, else
/// ~/.cache/sline (XDG Base Directory Specification: a relative XDG_CACHE_HOME counts as none).
/// Empty where neither is known. The folder need not exist.
std::filesystem::path userCacheFolder();

/// Where it keeps what a program must find again after a restart: $XDG_STATE_HOME/sline, else
/// ~/.local/state/sline.
std::filesystem::path userStateFolder();

}  // namespace sline::model
