// SPDX-License-Identifier: Apache-2.0
#include "model/disk/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <utility>

#include "model/disk/left_overs.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {

Error systemError(const fs::path& file, int code, std::string_view what, std::string_view remedy) {
  return Error{.file = file.string(),
               .reason = std::string(what) + ": " + std::generic_category().message(code),
               .remedy = std::string(remedy)};
}

constexpr std::string_view writeRemedy = "Choose a folder that exists and that you may write to";
constexpr std::string_view spaceRemedy = "Free some space on the disk, or choose another one";

Error notWritten(const fs::path& file, int code) {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return systemError(file, code, "it cannot be written", full ? spaceRemedy : writeRemedy);
}

/// Opens a file or folder, which is closed however its scope is left.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags)
      : m_value(open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (m_value >= 0)
      ::close(m_value);
  }
  bool valid() const { return m_value >= 0; }
  int value() const { return m_value; }

 private:
  int m_value;
};

/// Waits until the data are on the disk, so that a power cut after the renaming finds the new file
/// whole. File systems that cannot promise it return EINVAL; that is no reason to lose the file.
Status synced(const fs::path& path, int flags) {
  const Descriptor descriptor(path, flags);
  if (!descriptor.valid() || (fsync(descriptor.value()) != 0 && errno != EINVAL))
    return notWritten(path, errno);
  return Unit{};
}

Status renamed(const fs::path& temporary, const fs::path& file) {
  std::error_code failure;
  // The new file gets the permissions of the old one.
  if (const fs::file_status old = fs::status(file, failure); fs::exists(old))
    fs::permissions(temporary, old.permissions(), failure);
  fs::rename(temporary, file, failure);
  if (failure)
    return systemError(file, failure.value(), "it cannot be put in its place", writeRemedy);
  const fs::path folder = file.parent_path();
  return synced(folder.empty() ? fs::path(".") : folder, O_RDONLY | O_DIRECTORY);
}

}  // namespace

Status writeBeside(const fs::path& named, const std::function<Status(const fs::path&)>& write) {
  std::error_code failure;
  const fs::file_status status = fs::status(named, failure);
  if (fs::is_directory(status))
    return Error{.file = named.string(), .reason = "it is a folder", .remedy = "Name a file"};
  // The name is used as given: /dev/stdout may link to a pipe that has no path.
  if (fs::exists(status) && !fs::is_regular_file(status))
    return write(named);
  const fs::path file =
      fs::is_symlink(named, failure) ? fs::weakly_canonical(named, failure) : named;
  const auto part = PartBeside::take(file, PartBeside::Kind::file, failure);
  Status written = part ? write(part->path()) : notWritten(file, failure.value());
  if (written.ok())
    written = synced(part->path(), O_RDONLY);
  if (written.ok())
    written = renamed(part->path(), file);
  if (written.ok())
    return written;
  if (part)
    fs::remove(part->path(), failure);
  Error error = written.error();
  error.file = named.string();
  if (fs::exists(status))
    error.reason += "; the file that was there is whole, as it was";
  return error;
}

GrowingFile::GrowingFile(fs::path file, int descriptor)
    : m_file(std::move(file)), m_descriptor(descriptor) {}

GrowingFile::~GrowingFile() {
  if (m_descriptor >= 0)
    ::close(m_descriptor);
}

Result<std::unique_ptr<GrowingFile>> GrowingFile::create(const fs::path& file) {
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0)
    return notWritten(file, errno);
  return std::unique_ptr<GrowingFile>(new GrowingFile(file, descriptor));
}

Status GrowingFile::add(std::string_view bytes) {
  constexpr std::size_t atOnce = std::size_t(1) << 30;
  m_size += bytes.size();
  while (!bytes.empty()) {
    const ssize_t step = ::write(m_descriptor, bytes.data(), std::min(bytes.size(), atOnce));
    if (step < 0 && errno == EINTR)
      continue;
    if (step <= 0)
      return notWritten(m_file, step == 0 ? EIO : errno);
    bytes.remove_prefix(std::size_t(step));
  }
  return Unit{};
}

Status GrowingFile::replace(std::uint64_t offset, std::string_view bytes) {
  if (pwrite(m_descriptor, bytes.data(), bytes.size(), off_t(offset)) == ssize_t(bytes.size()))
    return Unit{};
  if (errno == ESPIPE)
    return Error{
        .file = m_file.string(),
        .reason = "this kind of file cannot go through a pipe: its beginning is written last",
        .remedy = "Name a file"};
  return notWritten(m_file, errno);
}

Status GrowingFile::close() {
  return ::close(std::exchange(m_descriptor, -1)) == 0 ? Status(Unit{})
                                                       : Status(notWritten(m_file, errno));
}

bool mayBeWritten(const fs::path& file) {
  std::error_code fault;
  if (!fs::exists(file, fault))
    return true;
  const fs::perms rights = fs::status(file, fault).permissions();
  constexpr fs::perms anybody =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  return fault || ((rights & anybody) != fs::perms::none && access(file.c_str(), W_OK) == 0);
}

Status writeText(const fs::path& file, std::string_view text) {
  return writeBeside(file, [&](const fs::path& target) -> Status {
    const std::unique_ptr<GrowingFile> growing = TRY(GrowingFile::create(target));
    TRY(growing->add(text));
    return growing->close();
  });
}

Result<std::string> readText(const fs::path& file, std::size_t limit) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::error_code failure;
  if (!stream || fs::is_directory(file, failure))
    return systemError(file, stream ? EISDIR : errno, "it cannot be read",
                       "Check the name and the rights");
  // The path may not be a plain file, so its size is a first guess.
  const std::uintmax_t size = fs::file_size(file, failure);
  std::string text(failure ? 0 : std::size_t(std::min<std::uintmax_t>(size, limit)) + 1, '\0');
  std::size_t got = 0;
  for (; got <= limit && stream; got += std::size_t(stream.gcount())) {
    if (got == text.size())
      text.resize(std::min(limit + 1, 2 * got + 4096));
    stream.read(text.data() + got, std::streamsize(text.size() - got));
  }
  text.resize(got);
  if (text.size() > limit)
    return Error{.file = file.string(),
                 .reason = "it is larger than " + std::to_string(limit) + " bytes",
                 .remedy = "Name the right file"};
  return text;
}

}  // namespace sline::model
