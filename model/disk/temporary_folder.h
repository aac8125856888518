// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

/// A folder of our own that nobody else may look into; it goes, with all in it, when the value
/// does.
class TemporaryFolder {
 public:
  /// Below the system's folder for such things; the error tells why not.
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
