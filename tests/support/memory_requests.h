// SPDX-License-Identifier: Apache-2.0
// Counts how often a thread asks for memory: a measure of its work that is the same on every
// machine, however busy.
#pragma once

#include <cstdint>

namespace sline::test {

/// Returns how often the calling thread has asked for memory since it began, by malloc, calloc,
/// realloc, or what calls them (operator new, Qt's containers). A program that calls this counts
/// them all. Sanitizers count theirs.
std::uint64_t memoryRequests();

}  // namespace sline::test
