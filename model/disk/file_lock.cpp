// SPDX-License-Identifier: Apache-2.0
#include "model/disk/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <string>
#include <system_error>

#include "model/disk/process.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {
constexpr int readableByAll = 0644;

/// Returns "process 4711 on anatomy-3", as the holder of the lock wrote it.
std::string holderOf(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t size = pread(descriptor, text.data(), text.size(), 0);
  std::string holder;
  for (ssize_t i = 0; i < size && text[std::size_t(i)] >= ' '; ++i)
    holder += text[std::size_t(i)];
  return holder.empty() ? "another program" : holder;
}

bool signedBy(int descriptor) {
  std::array<char, 128> host{};
  if (gethostname(host.data(), host.size() - 1) != 0)
    host[0] = '\0';
  const std::string text = "process " + std::to_string(processNumber()) +
                           (host[0] ? std::string(" on ") + host.data() : "") + "\n";
  return ftruncate(descriptor, 0) == 0 &&
         pwrite(descriptor, text.data(), text.size(), 0) == ssize_t(text.size());
}

/// Returns false where the file was removed, or made anew, between its opening and its locking.
bool stillThere(int descriptor, const fs::path& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

/// Says why there can be no lock at that path.
Error notLocked(const fs::path& named, const fs::path& path, int code) {
  const bool gone = code == ENOENT || code == ENOTDIR;
  return {
      .file = named.string(),
      .reason = gone ? "there is no folder " + path.parent_path().string()
                     : "its folder cannot be written to: " + std::generic_category().message(code),
      .remedy = "Save it under another name or in another folder"};
}

fs::path followed(const fs::path& file) {
  std::error_code fault;
  const fs::path real = fs::weakly_canonical(file, fault);
  return fault ? file : real;
}
}  // namespace

fs::path FileLock::besides(const fs::path& file) {
  return file.parent_path() / ("." + file.filename().string() + ".lock");
}

Result<FileLock> FileLock::acquire(const fs::path& named) {
  const fs::path file = followed(named);
  const fs::path path = besides(file);
  for (;;) {
    const int descriptor = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, readableByAll);
    if (descriptor < 0)
      return notLocked(named, path, errno);
    FileLock lock(file, descriptor);
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      // A holder lets nobody share it; who only looks whether it is held is gone in a moment.
      if (flock(descriptor, LOCK_SH | LOCK_NB) == 0) {
        close(std::exchange(lock.m_descriptor, -1));
        continue;
      }
      const std::string holder = holderOf(descriptor);
      close(std::exchange(lock.m_descriptor, -1));  // only the holder may remove the file
      return Error{.file = named.string(),
                   .reason = "it is open for writing in " + holder,
                   .remedy = "Close it there, or save it under another name"};
    }
    if (!stillThere(descriptor, path)) {
      close(std::exchange(lock.m_descriptor, -1));
      continue;
    }
    // The signature is only a courtesy: on a full disk the lock holds without it.
    static_cast<void>(signedBy(descriptor));
    return lock;
  }
}

bool FileLock::held(const fs::path& named) {
  const fs::path path = besides(followed(named));
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return false;
  const bool free = flock(descriptor, LOCK_SH | LOCK_NB) == 0;
  close(descriptor);
  return !free;
}

FileLock::FileLock(FileLock&& other) noexcept
    : m_file(std::move(other.m_file)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(m_file, other.m_file);
  std::swap(m_descriptor, other.m_descriptor);
  return *this;
}

FileLock::~FileLock() {
  if (m_descriptor < 0)
    return;
  // The file is removed while it is still locked, so that no other process's new lock is removed.
  unlink(besides(m_file).c_str());
  close(m_descriptor);
}

}  // namespace sline::model
