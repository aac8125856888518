// SPDX-License-Identifier: Apache-2.0
#include "model/disk/whole_folder.h"

#include <string>
#include <system_error>

#include "model/disk/left_overs.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {

Error notMade(const fs::path& folder, const std::error_code& failure) {
  return {.file = folder.string(),
          .reason = "the folder cannot be made: " + failure.message(),
          .remedy = "Choose a place that exists and that you may write to"};
}

Status free(const fs::path& folder) {
  std::error_code failure;
  const fs::file_status status = fs::status(folder, failure);
  if (!fs::exists(status))
    return Unit{};
  if (!fs::is_directory(status))
    return Error{.file = folder.string(),
                 .reason = "it is a file, and a folder is to be made",
                 .remedy = "Name a folder that is not there yet"};
  const bool empty = fs::is_empty(folder, failure);
  if (failure || !empty)
    return Error{.file = folder.string(),
                 .reason = failure ? "the folder cannot be read: " + failure.message()
                                   : "the folder is not empty",
                 .remedy = "Name a folder that is not there yet, or an empty one"};
  return Unit{};
}

/// Makes a new folder beside the wanted one. One of that name may exist already, left by a killed
/// program whose process number is now in use again.
Result<fs::path> folderBeside(const fs::path& folder) {
  constexpr int most = 100;
  for (int i = 0; i < most; ++i) {
    const fs::path beside = partBeside(folder, i);
    std::error_code failure;
    if (fs::create_directory(beside, failure))
      return beside;
    if (failure && failure != std::errc::file_exists)
      return notMade(folder, failure);
  }
  return notMade(folder, std::make_error_code(std::errc::file_exists));
}

}  // namespace

Status writeFolder(const fs::path& named, const std::function<Status(const fs::path&)>& write) {
  // "frames/" ends with an empty name.
  const fs::path folder = named.has_filename() ? named : named.parent_path();
  if (Status place = free(folder); !place.ok())
    return place;
  removeLeftOvers(folder);
  const Result<fs::path> temporary = folderBeside(folder);
  if (!temporary.ok())
    return temporary.error();
  Status written = write(*temporary);
  if (written.ok()) {
    std::error_code failure;
    fs::rename(*temporary, folder, failure);
    if (!failure)
      return written;
    written = notMade(folder, failure);
  }
  std::error_code ignored;
  fs::remove_all(*temporary, ignored);
  Error error = written.error();
  error.file = folder.string();
  return error;
}

}  // namespace sline::model
