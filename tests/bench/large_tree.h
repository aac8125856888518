// SPDX-License-Identifier: Apache-2.0
// How long a scene of very many structures keeps those waiting who ask about its tree.
#pragma once

#include <string>

namespace sline::bench {

/// Builds a tree of so many structures, some ten to a group and groups five deep, and returns a
/// line for each question with the least milliseconds of seven tries.
std::string measureTree(int structures);

}  // namespace sline::bench
