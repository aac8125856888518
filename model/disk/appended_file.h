// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "model/base/result.h"

namespace sline::model {

/// A file of the user's own that only grows, so that what was added survives the end of the program
/// in whatever way it comes. What a failed addition has left is cut off again.
class AppendedFile {
 public:
  /// Makes the file anew, empty; nobody but the user may read it.
  static Result<std::unique_ptr<AppendedFile>> create(const std::filesystem::path& file);
  /// Opens an existing file to add to it.
  static Result<std::unique_ptr<AppendedFile>> goOn(const std::filesystem::path& file);
  ~AppendedFile();
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;

  /// Hands the bytes to the system, which keeps them even if this process is killed. After an error
  /// the file is as long as before, and the next call may try again.
  Status add(std::string_view bytes);
  /// Waits until all that was added is on the disk, where a power cut does not reach it.
  Status sync();
  std::uint64_t size() const { return m_size; }

 private:
  AppendedFile(std::filesystem::path file, int descriptor, std::uint64_t size);
  static Result<std::unique_ptr<AppendedFile>> opened(const std::filesystem::path& file, int flags);
  std::filesystem::path m_file;
  int m_descriptor;
  std::uint64_t m_size;
};

}  // namespace sline::model
