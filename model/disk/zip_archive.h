// SPDX-License-Identifier: Apache-2.0
// Reads and writes ZIP files as lists of members, through libzip: the same members always give the
// same bytes, and files from outside are held to limits before any of them is unpacked.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::model {

/// Limits what a ZIP file may unpack to.
struct ZipLimits {
  std::size_t members = 200'000;
  std::size_t nameBytes = 1024;
  std::uint64_t unpackedBytes = std::uint64_t(8) << 30;  ///< of all members together
  std::uint64_t ratio = 200;                             ///< unpacked : file, beyond the first MiB
};

struct ZipMember {
  std::string name;  ///< UTF-8, folders separated by '/'
  std::string bytes;
};

/// Returns a ZIP file with the members in their order, each dated 1 January 1980 and without owner
/// or rights; `bytes` are read during the call. They are deflated, unless that would exceed the
/// ratio which readers allow: then all are stored uncompressed. Names must be unique and without a
/// fault by `zipNameFault`.
Result<std::string> zipped(const std::vector<const ZipMember*>& members);

/// Returns what is wrong with a member's name: absolute, with "..", with '\\', ':' or control
/// characters, empty or too long.
std::string zipNameFault(std::string_view name, const ZipLimits& limits = {});

/// Unpacks members one by one. The bytes must outlive the reader.
class ZipReader {
 public:
  struct Entry {
    std::string name;
    std::uint64_t index = 0;
    std::uint64_t size = 0;  ///< unpacked size
  };

  /// Reads only the list of members and refuses links, encrypted members, methods other than stored
  /// and deflated, names with faults or given twice, and anything beyond the limits. Folders, whose
  /// names end with '/', are skipped.
  static Result<ZipReader> open(std::string_view bytes, const ZipLimits& limits = {});

  const std::vector<Entry>& entries() const { return m_entries; }
  /// Returns the entry, or null where there is none of that name.
  const Entry* find(std::string_view name) const;
  /// Returns the unpacked member after comparing its length and checksum.
  Result<std::string> read(const Entry& entry) const;

 private:
  struct Close {
    void operator()(void* archive) const;
  };
  ZipReader() = default;
  Result<Entry> checkedEntry(std::uint64_t index, const ZipLimits& limits) const;

  std::unique_ptr<void, Close> m_archive;
  std::vector<Entry> m_entries;  ///< sorted by name
};

}  // namespace sline::model
