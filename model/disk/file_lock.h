// SPDX-License-Identifier: Apache-2.0
// Ensures that each scene file has one writer.
#pragma once

#include <filesystem>
#include <utility>

#include "model/base/result.h"

namespace sline::model {

/// Grants the right to write a scene file, from `acquire` until the lock is destroyed. The lock is
/// a file beside it, ".NAME.lock", locked by the system (flock), which releases it when its process
/// ends in any way: a file left by a crash locks nothing, and the next writer takes it over.
class FileLock {
 public:
  /// Takes the lock. The error says which process holds it, or that the folder cannot be written
  /// to. Links are followed.
  static Result<FileLock> acquire(const std::filesystem::path& file);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// Returns the file that may be written.
  const std::filesystem::path& file() const { return m_file; }
  /// Returns the path of a file's lock.
  static std::filesystem::path besides(const std::filesystem::path& file);
  /// Tells whether a process, this one included, holds the lock of that file.
  static bool held(const std::filesystem::path& file);

 private:
  FileLock(std::filesystem::path file, int descriptor)
      : m_file(std::move(file)), m_descriptor(descriptor) {}

  std::filesystem::path m_file;
  int m_descriptor = -1;
};

}  // namespace sline::model
