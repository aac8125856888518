// SPDX-License-Identifier: Apache-2.0
// Gives what is written its place beside where it goes, and takes over what killed writers have
// left there. No folder is listed for that, as many files may be written into a large one.
#pragma once

#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace sline::model {

/// A file or folder ".NAME.1.part" beside the one that is written, which it becomes by being
/// renamed. The system locks it (flock) until this is destroyed or its process ends in any way: one
/// that nobody holds was left by a writer that was killed, and the next one takes it over, empty.
class PartBeside {
 public:
  enum class Kind { file, folder };
  /// Takes the first place that no other writer holds. Absent where none can be made; the fault
  /// says why.
  static std::optional<PartBeside> take(const std::filesystem::path& named, Kind kind,
                                        std::error_code& fault);

  PartBeside(PartBeside&& other) noexcept
      : m_path(std::move(other.m_path)), m_descriptor(std::exchange(other.m_descriptor, -1)) {}
  PartBeside& operator=(PartBeside&&) = delete;
  ~PartBeside();

  const std::filesystem::path& path() const { return m_path; }

 private:
  PartBeside(std::filesystem::path path, int descriptor)
      : m_path(std::move(path)), m_descriptor(descriptor) {}

  std::filesystem::path m_path;
  int m_descriptor = -1;
};

}  // namespace sline::model
