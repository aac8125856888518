// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <utility>

#include "model/base/result.h"

namespace sline::model {

/// A temporary folder that no other user can read; it is removed with all its contents when the
/// value is destroyed. Those of processes that were killed are removed when the next one is made.
class TemporaryFolder {
 public:
  /// Makes the folder below the system's temporary folder; the error says why it failed.
  static Result<TemporaryFolder> create();
  TemporaryFolder(TemporaryFolder&& other) noexcept
      : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {
    other.m_path.clear();
  }
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
    std::swap(m_path, other.m_path);
    std::swap(m_descriptor, other.m_descriptor);
    return *this;
  }
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return m_path; }

 private:
  explicit TemporaryFolder(std::filesystem::path path);
  std::filesystem::path m_path;
  int m_descriptor = -1;  ///< holds the folder's lock as long as it is in use
};

}  // namespace sline::model
