// SPDX-License-Identifier: Apache-2.0
#include "model/disk/file_state.h"

#include <sys/stat.h>

namespace sline::model {

std::optional<FileState> fileState(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode))
    return std::nullopt;
  return FileState{.device = std::uint64_t(found.st_dev),
                   .number = std::uint64_t(found.st_ino),
                   .bytes = std::uint64_t(found.st_size),
                   .seconds = std::int64_t(found.st_ctim.tv_sec),
                   .nanoseconds = std::int64_t(found.st_ctim.tv_nsec)};
}

}  // namespace sline::model
