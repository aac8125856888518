// SPDX-License-Identifier: Apache-2.0
#include "model/disk/zip_archive.h"

#include <zip.h>

#include <algorithm>
#include <cassert>
#include <memory>

namespace sline::model {

namespace {
/// Beyond this level the bytes of meshes shrink by 3 % more and take twice the time.
constexpr int deflateLevel = 3;
/// The date is 1 January 1980, 00:00:00, the first moment that a ZIP file can name.
constexpr zip_uint16_t fixedDate = 1 << 5 | 1;
constexpr std::uint64_t alwaysAllowed = std::uint64_t(1) << 20;
/// The file type lies in the upper half of the attributes that Unix programs write; below is that
/// of a link.
constexpr zip_uint32_t typeMask = 0170000;
constexpr zip_uint32_t linkType = 0120000;

struct DropSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using SourcePtr = std::unique_ptr<zip_source_t, DropSource>;

Error failed(zip_error_t* error, const std::string& what, const std::string& where = {}) {
  Error told{.where = where, .reason = what + ": " + zip_error_strerror(error)};
  zip_error_fini(error);
  return told;
}

Error failed(zip_t* archive, const std::string& what, const std::string& where = {}) {
  return {.where = where, .reason = what + ": " + zip_error_strerror(zip_get_error(archive))};
}

constexpr const char* zipNotMade = "the ZIP file cannot be made";

Result<Unit> add(zip_t* archive, const ZipMember& member, int method) {
  zip_source_t* source = zip_source_buffer(archive, member.bytes.data(), member.bytes.size(), 0);
  if (!source)
    return failed(archive, zipNotMade, member.name);
  const zip_int64_t index = zip_file_add(archive, member.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    return failed(archive, zipNotMade, member.name);
  }
  const auto at = zip_uint64_t(index);
  if (zip_set_file_compression(archive, at, method, deflateLevel) != 0 ||
      zip_file_set_dostime(archive, at, 0, fixedDate, 0) != 0 ||
      zip_file_set_external_attributes(archive, at, 0, ZIP_OPSYS_DOS, 0) != 0)
    return failed(archive, zipNotMade, member.name);
  return Unit{};
}

Result<std::string> contentsOf(zip_source_t* source) {
  zip_stat_t stat;
  if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0)
    return Error{.reason = zipNotMade};
  std::string bytes(stat.size, '\0');
  const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (got != zip_int64_t(bytes.size()))
    return Error{.reason = zipNotMade};
  return bytes;
}

Result<std::string> zippedBy(int method, const std::vector<const ZipMember*>& members) {
  zip_error_t error;
  zip_error_init(&error);
  const SourcePtr target(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!target)
    return failed(&error, zipNotMade);
  zip_t* archive = zip_open_from_source(target.get(), ZIP_TRUNCATE, &error);
  if (!archive)
    return failed(&error, zipNotMade);
  zip_source_keep(target.get());
  for (const ZipMember* member : members)
    if (const Result<Unit> added = add(archive, *member, method); !added.ok()) {
      zip_discard(archive);
      return added.error();
    }
  if (zip_close(archive) != 0) {
    const Error told = failed(archive, zipNotMade);
    zip_discard(archive);
    return told;
  }
  return contentsOf(target.get());
}

bool withinRatio(std::uint64_t unpacked, std::uint64_t file, const ZipLimits& limits) {
  return unpacked <= alwaysAllowed || unpacked - alwaysAllowed <= limits.ratio * file;
}
}  // namespace

Result<std::string> zipped(const std::vector<const ZipMember*>& members) {
  std::uint64_t unpacked = 0;
  for (const ZipMember* member : members) {
    assert(zipNameFault(member->name).empty());
    unpacked += member->bytes.size();
  }
  Result<std::string> deflated = zippedBy(ZIP_CM_DEFLATE, members);
  if (!deflated.ok() || withinRatio(unpacked, deflated->size(), {}))
    return deflated;
  return zippedBy(ZIP_CM_STORE, members);
}

std::string zipNameFault(std::string_view name, const ZipLimits& limits) {
  if (name.empty())
    return "it has no name";
  if (name.size() > limits.nameBytes)
    return "its name is too long";
  if (name.front() == '/')
    return "its name is an absolute path";
  for (const char c : name)
    if (c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20)
      return "its name has a character that a path of a ZIP file may not have";
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find('/', start), name.size());
    if (name.substr(start, end - start) == "..")
      return "its name leads out of the file by \"..\"";
    start = end + 1;
  }
  return {};
}

void ZipReader::Close::operator()(void* archive) const {
  zip_discard(static_cast<zip_t*>(archive));
}

Result<ZipReader::Entry> ZipReader::checkedEntry(std::uint64_t index,
                                                 const ZipLimits& limits) const {
  auto* archive = static_cast<zip_t*>(m_archive.get());
  const std::string number = "member " + std::to_string(index);
  zip_stat_t stat;
  zip_stat_init(&stat);
  if (zip_stat_index(archive, index, 0, &stat) != 0)
    return failed(archive, "it cannot be read", number);
  Entry entry{stat.name ? stat.name : "", index, stat.size};
  const auto refused = [&](const std::string& reason) {
    return Error{.where = number, .reason = reason};
  };
  if (const std::string fault = zipNameFault(entry.name, limits); !fault.empty())
    return refused(fault);
  constexpr zip_uint64_t wanted = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
  if ((stat.valid & wanted) != wanted)
    return refused("its size is not told");
  if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 && stat.encryption_method != ZIP_EM_NONE)
    return refused("it is encrypted");
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    return refused("it is packed by a method other than deflate");
  if (stat.comp_method == ZIP_CM_STORE && stat.comp_size != stat.size)
    return refused("its two sizes differ, though it is not packed");
  zip_uint8_t system = 0;
  zip_uint32_t attributes = 0;
  if (zip_file_get_external_attributes(archive, index, 0, &system, &attributes) == 0 &&
      system == ZIP_OPSYS_UNIX && (attributes >> 16 & typeMask) == linkType)
    return refused("it is a link");
  return entry;
}

Result<ZipReader> ZipReader::open(std::string_view bytes, const ZipLimits& limits) {
  if (bytes.empty())
    return Error{.reason = "it is empty"};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (!source)
    return failed(&error, "it cannot be read");
  zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (!archive) {
    zip_source_free(source);
    return failed(&error, "it is no whole ZIP file");
  }
  ZipReader reader;
  reader.m_archive.reset(archive);
  const auto count = std::uint64_t(zip_get_num_entries(archive, 0));
  if (count > limits.members)
    return Error{.reason = "it has more than " + std::to_string(limits.members) + " members"};
  std::uint64_t unpacked = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    Entry entry = TRY(reader.checkedEntry(i, limits));
    if (entry.name.back() == '/')
      continue;
    if (entry.size > limits.unpackedBytes || (unpacked += entry.size) > limits.unpackedBytes)
      return Error{.reason = "its members would take more than " +
                             std::to_string(limits.unpackedBytes) + " bytes"};
    reader.m_entries.push_back(std::move(entry));
  }
  if (!withinRatio(unpacked, bytes.size(), limits))
    return Error{.reason = "it would grow to more than " + std::to_string(limits.ratio) +
                           " times its size"};
  auto& entries = reader.m_entries;
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  const auto twice =
      std::adjacent_find(entries.begin(), entries.end(),
                         [](const Entry& a, const Entry& b) { return a.name == b.name; });
  if (twice != entries.end())
    return Error{.where = twice->name, .reason = "there are two members of this name"};
  return reader;
}

const ZipReader::Entry* ZipReader::find(std::string_view name) const {
  const auto found =
      std::lower_bound(m_entries.begin(), m_entries.end(), name,
                       [](const Entry& entry, std::string_view n) { return entry.name < n; });
  return found != m_entries.end() && found->name == name ? &*found : nullptr;
}

Result<std::string> ZipReader::read(const Entry& entry) const {
  auto* archive = static_cast<zip_t*>(m_archive.get());
  zip_file_t* file = zip_fopen_index(archive, entry.index, 0);
  if (!file)
    return failed(archive, "it cannot be unpacked", entry.name);
  std::string bytes(entry.size, '\0');
  std::uint64_t got = 0;
  zip_int64_t step = 0;
  while (got < entry.size && (step = zip_fread(file, bytes.data() + got, entry.size - got)) > 0)
    got += std::uint64_t(step);
  // Reading on to the end makes libzip compare the checksum.
  char beyond = 0;
  const bool more = got == entry.size && zip_fread(file, &beyond, 1) != 0;
  if (got == entry.size && !more) {
    zip_fclose(file);
    return bytes;
  }
  Error error{.where = entry.name, .reason = "it is cut or damaged"};
  if (step < 0 || more)
    error.reason += std::string(": ") + zip_error_strerror(zip_file_get_error(file));
  zip_fclose(file);
  return error;
}

}  // namespace sline::model
