// SPDX-License-Identifier: Apache-2.0
#include "model/disk/left_overs.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "model/disk/process.h"

namespace sline::model {

namespace fs = std::filesystem;

namespace {

/// So many writers of the same file may be at work; so many left-overs beyond are looked for.
constexpr int mostWriters = 100;
constexpr int sweptBeyond = 3;

fs::path placeOf(const fs::path& named, const std::string& what) {
  return named.parent_path() / ("." + named.filename().string() + "." + what + ".part");
}

/// Opens the file or folder, which `flags` may make; a negative number where that fails.
int opened(const fs::path& path, PartBeside::Kind kind, int flags) {
  if (kind == PartBeside::Kind::file)
    return open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | flags, 0666);
  if ((flags & O_CREAT) != 0 && mkdir(path.c_str(), 0777) != 0 && errno != EEXIST)
    return -1;
  return open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

enum class Lock { held, taken, unknown };

/// Tries to lock what is open at the path. Who held it may have given it another name since.
Lock lock(const fs::path& path, int descriptor) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) != 0)
    return errno == EWOULDBLOCK ? Lock::taken : Lock::unknown;
  struct stat locked {};
  struct stat there {};
  const bool same = fstat(descriptor, &locked) == 0 && lstat(path.c_str(), &there) == 0 &&
                    locked.st_ino == there.st_ino && locked.st_dev == there.st_dev;
  return same ? Lock::held : Lock::taken;
}

/// Takes away what is in the file or folder; returns false where that fails.
bool emptied(const fs::path& path, PartBeside::Kind kind, int descriptor) {
  if (kind == PartBeside::Kind::file)
    return ftruncate(descriptor, 0) == 0;
  std::error_code fault;
  for (fs::directory_iterator entry(path, fault), end; !fault && entry != end;
       entry.increment(fault))
    if (std::error_code kept; fs::remove_all(entry->path(), kept) == 0 || kept)
      return false;
  return !fault;
}

void removeLeft(const fs::path& path, PartBeside::Kind kind) {
  const int descriptor = opened(path, kind, 0);
  if (descriptor < 0)
    return;
  std::error_code fault;
  if (lock(path, descriptor) == Lock::held)
    fs::remove_all(path, fault);
  close(descriptor);
}

}  // namespace

PartBeside::~PartBeside() {
  if (m_descriptor >= 0)
    close(m_descriptor);
}

std::optional<PartBeside> PartBeside::take(const fs::path& named, Kind kind,
                                           std::error_code& fault) {
  fault.clear();
  for (int number = 1; number <= mostWriters; ++number) {
    fs::path path = placeOf(named, std::to_string(number));
    const int descriptor = opened(path, kind, O_CREAT);
    if (descriptor < 0) {
      if (!fault)
        fault.assign(errno, std::generic_category());
      continue;
    }
    const Lock got = lock(path, descriptor);
    if (got == Lock::held && emptied(path, kind, descriptor)) {
      for (int beyond = number + 1; beyond <= number + sweptBeyond; ++beyond)
        removeLeft(placeOf(named, std::to_string(beyond)), kind);
      return PartBeside(std::move(path), descriptor);
    }
    close(descriptor);
    if (got != Lock::unknown)
      continue;
    // A file system without locks: nobody else has the place of this process.
    fs::remove(path, fault);
    path = placeOf(named, std::to_string(processNumber()) + "-" + std::to_string(number));
    const int own = opened(path, kind, O_CREAT | O_EXCL);
    if (own >= 0)
      return PartBeside(std::move(path), own);
    fault.assign(errno, std::generic_category());
  }
  if (!fault)
    fault = std::make_error_code(std::errc::file_exists);
  return std::nullopt;
}

}  // namespace sline::model
