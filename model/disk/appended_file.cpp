// SPDX-License-Identifier: Apache-2.0
#include "model/disk/appended_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace sline::model {

namespace fs = std::filesystem;

namespace {
constexpr int ownersAlone = 0600;

Error notAppended(const fs::path& file, int code) {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return Error{.file = file.string(),
               .reason = "it cannot be written: " + std::generic_category().message(code),
               .remedy = full ? "Free some space on its disk" : "Check the rights of its folder"};
}
}  // namespace

AppendedFile::AppendedFile(fs::path file, int descriptor, std::uint64_t size)
    : m_file(std::move(file)), m_descriptor(descriptor), m_size(size) {}

AppendedFile::~AppendedFile() {
  ::close(m_descriptor);
}

Result<std::unique_ptr<AppendedFile>> AppendedFile::opened(const fs::path& file, int flags) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, ownersAlone);
  if (descriptor < 0)
    return notAppended(file, errno);
  struct stat status {};
  if (fstat(descriptor, &status) != 0) {
    const Error error = notAppended(file, errno);
    ::close(descriptor);
    return error;
  }
  return std::unique_ptr<AppendedFile>(
      new AppendedFile(file, descriptor, std::uint64_t(status.st_size)));
}

Result<std::unique_ptr<AppendedFile>> AppendedFile::create(const fs::path& file) {
  return opened(file, O_CREAT | O_TRUNC);
}

Result<std::unique_ptr<AppendedFile>> AppendedFile::goOn(const fs::path& file) {
  return opened(file, 0);
}

Status AppendedFile::add(std::string_view bytes) {
  std::uint64_t at = m_size;
  while (!bytes.empty()) {
    const ssize_t step = pwrite(m_descriptor, bytes.data(), bytes.size(), off_t(at));
    if (step < 0 && errno == EINTR)
      continue;
    if (step <= 0) {
      const int code = step == 0 ? EIO : errno;
      // Where even that fails, the next addition overwrites the rest: it is written at the offset.
      static_cast<void>(ftruncate(m_descriptor, off_t(m_size)) == 0);
      return notAppended(m_file, code);
    }
    bytes.remove_prefix(std::size_t(step));
    at += std::uint64_t(step);
  }
  m_size = at;
  return Unit{};
}

Status AppendedFile::sync() {
  // EINVAL comes from file systems that cannot promise it.
  if (fdatasync(m_descriptor) != 0 && errno != EINVAL)
    return notAppended(m_file, errno);
  return Unit{};
}

}  // namespace sline::model
