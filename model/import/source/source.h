// SPDX-License-Identifier: Apache-2.0
// Reads one file once into memory, and makes errors that point into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

/// Holds the bytes of a file and its name as the user gave it. Every parser reads from here, so a
/// place in a file is a pointer into `text()`.
class Source {
 public:
  /// Refuses folders, devices, empty files and files above `limits.fileBytes`. A file that is
  /// called .gz and packed by gzip is unpacked, within the same limit and the bound for so many
  /// packed bytes (mostOfSurface); places in it are then those in the unpacked text.
  static Result<Source> read(const std::filesystem::path& file, const ReadLimits& limits);
  /// Reads the file packed or not as it is stored, for readers that unpack piece by piece. No more
  /// than `most` bytes from the file's beginning are read.
  static Result<Source> readStored(const std::filesystem::path& file, const ReadLimits& limits,
                                   std::size_t most = SIZE_MAX);

  std::string_view text() const { return {m_bytes.get(), m_size}; }
  const char* begin() const { return m_bytes.get(); }
  const char* end() const { return m_bytes.get() + m_size; }
  std::size_t size() const { return m_size; }
  const std::string& file() const { return m_file; }
  const ReadLimits& limits() const { return m_limits; }

  /// Makes an error about the whole file. The remedy is "export the mesh again" unless one is
  /// given.
  Error whole(std::string reason, std::string remedy = {}) const;
  /// Makes an error that gives `place` as the line it stands in.
  Error atLine(const char* place, std::string reason, std::string remedy = {}) const;
  /// Makes an error that gives `place` as bytes from the file's beginning.
  Error atByte(const char* place, std::string reason, std::string remedy = {}) const;
  /// Makes an error at `where`, which names a place that is neither line nor byte: "accessors[3]".
  Error at(std::string where, std::string reason, std::string remedy = {}) const;
  ImportWarning warning(std::string reason) const { return {m_file, std::move(reason)}; }

 private:
  Source() = default;
  /// Replaces the packed bytes by their unpacked content.
  Status unpack();
  std::unique_ptr<char[]> m_bytes;
  std::size_t m_size = 0;
  std::string m_file;
  ReadLimits m_limits;
};

/// Returns a frame of reference named in a comment or title, "SPACE=LPS" or "SPACE=RAS" as 3D
/// Slicer writes.
std::optional<Frame> frameInText(std::string_view text);

/// Returns `word` shortened and with control characters replaced, so that it may stand in a
/// message.
std::string inQuotes(std::string_view word);

}  // namespace sline::model
