// SPDX-License-Identifier: Apache-2.0
// The reading child's side: takes the request, reads under confinement, answers.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// A reader that works in a child, by the kind of file it is for.
struct ChildReader {
  std::string_view kind;  ///< FileKind::name
  Result<RawMeshes> (*read)(std::span<const std::filesystem::path>, const ReadOptions&);
};

/// A reader of one file as a ChildReader wants it.
template <auto reader>
Result<RawMeshes> readingFirst(std::span<const std::filesystem::path> files,
                               const ReadOptions& options) {
  return reader(files.front(), options);
}

/// Descriptor over which request and answer go: a file in memory.
inline constexpr int exchangeDescriptor = 3;

/// Does what the request on `exchangeDescriptor` asks for, writes the answer in its place and ends
/// the process. Returns only where there was no request, with the status to end with.
int runReadingChild(std::span<const ChildReader> readers);

}  // namespace sline::model
