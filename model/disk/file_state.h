// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace sline::model {

/// What the system says of a file without reading it. While it says the same, nobody has written to
/// the file, as long as it has not changed within the last few milliseconds before: the time of
/// change cannot be set, unlike that of the content. A copy has another state.
struct FileState {
  std::uint64_t device = 0;
  std::uint64_t number = 0;  ///< of the file on its device
  std::uint64_t bytes = 0;
  std::int64_t seconds = 0;  ///< since 1970, when content, name or rights changed last
  std::int64_t nanoseconds = 0;
  bool operator==(const FileState&) const = default;
};

/// Returns the state of the file, or of that which a link leads to; none where there is no plain
/// file.
std::optional<FileState> fileState(const std::filesystem::path& file);

}  // namespace sline::model
