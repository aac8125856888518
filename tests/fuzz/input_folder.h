// SPDX-License-Identifier: Apache-2.0
// Makes paths out of bytes, since readers take paths.
#pragma once

#include <filesystem>
#include <string_view>

namespace sline::fuzz {

/// An InputFolder is a folder of this process alone, below TMPDIR. It holds what it was given and
/// nothing else, so a file that refers to others finds itself or nothing. It is removed with the
/// object.
class InputFolder {
 public:
  InputFolder();
  ~InputFolder();
  InputFolder(const InputFolder&) = delete;
  InputFolder& operator=(const InputFolder&) = delete;

  /// Writes the bytes as "input" with that extension; aborts if they cannot be written.
  std::filesystem::path put(std::string_view extension, std::string_view bytes) const;

 private:
  std::filesystem::path m_folder;
};

}  // namespace sline::fuzz
