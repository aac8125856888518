// SPDX-License-Identifier: Apache-2.0
// ZIP files as lists of members, through libzip: the same members always give the same bytes, and
// what comes from outside is held to limits before any of it is unpacked.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"

namespace sline::model {

/// Of what a ZIP file may unpack to.
struct ZipLimits {
  std::size_t members = 200'000;
  std::size_t nameBytes = 1024;
  std::uint64_t unpackedBytes = std::uint64_t(8) << 30;  ///< of all members
  std::uint64_t ratio = 200;                             ///< unpacked : file, beyond the first MiB
};

struct ZipMember {
  std::string name;  ///< UTF-8, folders parted by '/'
  std::string bytes;
};

/// The members in their order, each of 1 January 1980 and without owner or rights; `bytes` are read
/// from while it runs. Deflated, unless that would go beyond the ratio which readers allow: then
/// all are stored as they are. Names must be different ones that `zipNameFault` has nothing
/// against.
Result<std::string> zipped(const std::vector<const ZipMember*>& members);

/// What is wrong with a member's name: absolute, with "..", with '\\', ':' or control characters,
/// empty or too long.
std::string zipNameFault(std::string_view name, const ZipLimits& limits = {});

/// Unpacks members one by one. The bytes must outlive it.
class ZipReader {
 public:
  struct Entry {
    std::string name;
    std::uint64_t index = 0;
    std::uint64_t size = 0;  ///< unpacked
  };

  /// Looks at the list of members only: refuses links, encrypted members, methods other than stored
  /// and deflated, names with faults or given twice, and what is beyond the limits. Folders, whose
  /// names end with '/', are passed over.
  static Result<ZipReader> open(std::string_view bytes, const ZipLimits& limits = {});

  const std::vector<Entry>& entries() const { return m_entries; }
  /// Null where there is none of that name.
  const Entry* find(std::string_view name) const;
  /// Unpacked, its length and checksum compared.
  Result<std::string> read(const Entry& entry) const;

 private:
  struct Close {
    void operator()(void* archive) const;
  };
  ZipReader() = default;
  Result<Entry> checkedEntry(std::uint64_t index, const ZipLimits& limits) const;

  std::unique_ptr<void, Close> m_archive;
  std::vector<Entry> m_entries;  ///< by name
};

}  // namespace sline::model
