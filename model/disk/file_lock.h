// SPDX-License-Identifier: Apache-2.0
// One writer per scene file.
#pragma once

#include <filesystem>
#include <utility>

#include "model/base/result.h"

namespace sline::model {

/// The right to write a scene file, held from `acquire` until the lock is destroyed. It stands in a
/// file beside it, ".NAME.lock", locked by the system (flock), which lets go of it when its process
/// ends in whatever way: a file left by a crash locks nothing, and the next writer takes it over.
class FileLock {
 public:
  /// The error says who holds it, or that the folder cannot be written to. Links are followed.
  static Result<FileLock> acquire(const std::filesystem::path& file);

  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

  /// The file that may be written.
  const std::filesystem::path& file() const { return m_file; }
  /// Where the lock of a file stands.
  static std::filesystem::path besides(const std::filesystem::path& file);
  /// True while a process, this one included, holds the lock of that file.
  static bool held(const std::filesystem::path& file);

 private:
  FileLock(std::filesystem::path file, int descriptor)
      : m_file(std::move(file)), m_descriptor(descriptor) {}

  std::filesystem::path m_file;
  int m_descriptor = -1;
};

}  // namespace sline::model
