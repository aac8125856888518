// SPDX-License-Identifier: Apache-2.0
// Writes files that appear whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"

namespace sline::model {

/// Lets write(temporary) write a file beside `file` and puts it in its place when that succeeded
/// and the data are on the disk, so that a full disk, a crash or a power cut leaves either the old
/// file or the new one whole. A link keeps pointing to its file, and the file keeps its rights. An
/// existing path that is no plain file (a pipe, /dev/stdout) is written directly.
Status writeBeside(const std::filesystem::path& file,
                   const std::function<Status(const std::filesystem::path&)>& write);

/// A file that is written piece by piece, meant for the temporary file of `writeBeside`.
class GrowingFile {
 public:
  static Result<std::unique_ptr<GrowingFile>> create(const std::filesystem::path& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  Status add(std::string_view bytes);
  /// Returns the number of bytes added so far.
  std::uint64_t size() const { return m_size; }
  /// Overwrites bytes at an offset; fails for a path that is no plain file.
  Status replace(std::uint64_t offset, std::string_view bytes);
  /// Closes the file and returns the errors that the system reports late, too.
  Status close();

 private:
  GrowingFile(std::filesystem::path file, int descriptor);
  std::filesystem::path m_file;
  int m_descriptor;
  std::uint64_t m_size = 0;
};

/// Tells whether the file's rights allow writing; true also where there is no file, since its
/// folder then decides. A read-only file counts as protected even for root, who could write it.
bool mayBeWritten(const std::filesystem::path& file);

/// Writes the text, which may hold any bytes.
Status writeText(const std::filesystem::path& file, std::string_view text);

/// Returns the whole file, at most `limit` bytes, or the reason why it cannot be read.
Result<std::string> readText(const std::filesystem::path& file, std::size_t limit);

}  // namespace sline::model
