// SPDX-License-Identifier: Apache-2.0
#include "model/files/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace sline::model {

namespace fs = std::filesystem;

namespace {

Error systemError(const fs::path& file, int code, std::string_view what, std::string_view remedy) {
  return Error{.file = file.string(),
               .reason = std::string(what) + ": " + std::generic_category().message(code),
               .remedy = std::string(remedy)};
}

constexpr std::string_view writeRemedy = "Choose a folder that exists and that you may write to";

}  // namespace

Status writeBeside(const fs::path& file, const std::function<Status(const fs::path&)>& write) {
  std::error_code failure;
  const fs::file_status status = fs::status(file, failure);
  if (fs::is_directory(status))
    return Error{.file = file.string(), .reason = "it is a folder", .remedy = "Name a file"};
  if (fs::exists(status) && !fs::is_regular_file(status))
    return write(file);
  const fs::path temporary =
      file.parent_path() / ("." + file.filename().string() + "." + std::to_string(getpid()));
  if (Status written = write(temporary); !written.ok()) {
    fs::remove(temporary, failure);
    Error error = written.error();
    error.file = file.string();
    return error;
  }
  fs::rename(temporary, file, failure);
  if (!failure)
    return Unit{};
  const int code = failure.value();
  fs::remove(temporary, failure);
  return systemError(file, code, "it cannot be put in its place", writeRemedy);
}

Status writeText(const fs::path& file, std::string_view text) {
  return writeBeside(file, [&](const fs::path& target) -> Status {
    errno = 0;
    std::ofstream stream(target, std::ios::binary);
    stream.write(text.data(), std::streamsize(text.size()));
    stream.close();
    if (!stream)
      return systemError(target, errno, "it cannot be written", writeRemedy);
    return Unit{};
  });
}

Result<std::string> readText(const fs::path& file, std::size_t limit) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::error_code failure;
  if (!stream || fs::is_directory(file, failure))
    return systemError(file, stream ? EISDIR : errno, "it cannot be read",
                       "Check the name and the rights");
  std::string text(limit + 1, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  if (text.size() > limit)
    return Error{.file = file.string(),
                 .reason = "it is larger than " + std::to_string(limit) + " bytes",
                 .remedy = "Name the right file"};
  return text;
}

}  // namespace sline::model
