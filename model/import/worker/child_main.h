// SPDX-License-Identifier: Apache-2.0
// Implements the reading child's side: takes the request, reads under confinement, answers.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Describes a reader that works in a child, by its kind of file.
struct ChildReader {
  std::string_view kind;  ///< FileKind::name
  Result<RawMeshes> (*read)(std::span<const std::filesystem::path>, const ReadOptions&);
};

/// Adapts a reader of one file to ChildReader.
template <auto reader>
Result<RawMeshes> readingFirst(std::span<const std::filesystem::path> files,
                               const ReadOptions& options) {
  return reader(files.front(), options);
}

/// The descriptor over which request and answer go: a file in memory.
inline constexpr int exchangeDescriptor = 3;

/// Does the work of the request on `exchangeDescriptor`, writes the answer in its place and ends
/// the process. Returns only where there was no request, with the status to end with.
int runReadingChild(std::span<const ChildReader> readers);

}  // namespace sline::model
