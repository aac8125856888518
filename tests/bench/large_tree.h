// SPDX-License-Identifier: Apache-2.0
// Measures how long a scene of very many structures takes to answer questions about its tree.
#pragma once

#include <string>

namespace sline::bench {

/// Builds a tree of that many structures, some ten to a group and groups five deep, and returns a
/// line for each question with the least milliseconds of seven tries.
std::string measureTree(int structures);

}  // namespace sline::bench
