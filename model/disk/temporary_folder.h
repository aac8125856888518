// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

/// A temporary folder that no other user can read; it is removed with all its contents when the
/// value is destroyed.
class TemporaryFolder {
 public:
  /// Makes the folder below the system's temporary folder; the error says why it failed.
  static Result<TemporaryFolder> create();
  TemporaryFolder(TemporaryFolder&& other) noexcept : m_path(std::move(other.m_path)) {
    other.m_path.clear();
  }
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
    std::swap(m_path, other.m_path);
    return *this;
  }
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return m_path; }

 private:
  explicit TemporaryFolder(std::filesystem::path path) : m_path(std::move(path)) {}
  std::filesystem::path m_path;
};

}  // namespace sline::model
