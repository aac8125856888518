// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace sline::model {

/// Where the user's system keeps what a program can make again: $XDG_CACHE_HOME/sline, else
/// ~/.cache/sline (XDG Base Directory Specification: a relative XDG_CACHE_HOME counts as none).
/// Empty where neither is known. The folder need not exist.
std::filesystem::path userCacheFolder();

}  // namespace sline::model
