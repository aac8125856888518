// SPDX-License-Identifier: Apache-2.0
// Files that appear whole or not at all.
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
/// and the disk has it, so that a full disk, a crash or a power cut leaves the old file or the new
/// one whole. A link keeps pointing to its file, and the file keeps its rights. What exists and is
/// no plain file (a pipe, /dev/stdout) is written directly.
Status writeBeside(const std::filesystem::path& file,
                   const std::function<Status(const std::filesystem::path&)>& write);

/// A file that is written bit by bit; meant for what `writeBeside` gives to write.
class GrowingFile {
 public:
  static Result<std::unique_ptr<GrowingFile>> create(const std::filesystem::path& file);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  Status add(std::string_view bytes);
  /// Bytes added so far.
  std::uint64_t size() const { return m_size; }
  /// Writes over what is there; fails for what is no plain file.
  Status replace(std::uint64_t offset, std::string_view bytes);
  /// Says, too, what the system reports late.
  Status close();

 private:
  GrowingFile(std::filesystem::path file, int descriptor);
  std::filesystem::path m_file;
  int m_descriptor;
  std::uint64_t m_size = 0;
};

/// Returns whether the file's rights let it be written, or its folder decides because there is
/// none. Root may write whatever they say, but was asked not to.
bool mayBeWritten(const std::filesystem::path& file);

/// Any bytes.
Status writeText(const std::filesystem::path& file, std::string_view text);

/// The whole file, or why not; at most `limit` bytes.
Result<std::string> readText(const std::filesystem::path& file, std::size_t limit);

}  // namespace sline::model
