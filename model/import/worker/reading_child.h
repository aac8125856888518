// SPDX-License-Identifier: Apache-2.0
// Reads in a process of its own, for kinds of file with readers that stand on libraries that a
// damaged file may bring down: whatever happens there becomes an error here.
#pragma once

#include <filesystem>
#include <span>

#include "model/import/worker/exchange.h"

namespace sline::model {

/// Returns the program that reads: the one that the environment names in SLINE_READER, else
/// `sline-reader` beside the running program or in ../lib/sline. Empty where there is none.
std::filesystem::path readerProgram();

/// Asks the child to read files that belong together, most often one. It is ended as soon as
/// `options.goesOn` says no, when it has used `options.limits.childSeconds` of computing or takes
/// six times as long, and when it wants more than `options.limits.childBytes` of memory; it cannot
/// reach the network or start programs. Each of these, a crash, and an answer that makes no sense
/// are errors that say so.
Result<RawMeshes> readInChild(std::string_view kind, std::span<const std::filesystem::path> files,
                              const ReadOptions& options);

}  // namespace sline::model
