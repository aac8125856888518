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

}  // namespace

Status writeFolder(const fs::path& named, const std::function<Status(const fs::path&)>& write) {
  // "frames/" ends with an empty name.
  const fs::path folder = named.has_filename() ? named : named.parent_path();
  TRY(free(folder));
  std::error_code failure;
  const auto part = PartBeside::take(folder, PartBeside::Kind::folder, failure);
  if (!part)
    return notMade(folder, failure);
  Status written = write(part->path());
  if (written.ok()) {
    fs::rename(part->path(), folder, failure);
    if (!failure)
      return written;
    written = notMade(folder, failure);
  }
  fs::remove_all(part->path(), failure);
  Error error = written.error();
  error.file = folder.string();
  return error;
}

}  // namespace sline::model
