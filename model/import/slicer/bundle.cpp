// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/bundle.h"

#include <algorithm>
#include <array>
#include <string>

#include "model/base/letters.h"
#include "model/disk/whole_file.h"
#include "model/disk/zip_archive.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/slicer/fiducials.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Meshes and scenes as text shrink to a tenth; a file that grows more is no bundle.
constexpr ZipLimits bundleLimits{
    .members = 20'000, .unpackedBytes = std::uint64_t(4) << 30, .ratio = 50};
constexpr const char* remedy = "Save the bundle again in 3D Slicer";

Error of(const fs::path& file, Error error) {
  error.file = file.string();
  if (error.remedy.empty())
    error.remedy = remedy;
  return error;
}

bool isScene(const std::string& name) {
  return equalsIgnoringCase(fs::path(name).extension().string(), ".mrml");
}

/// Tells whether the file is one in which a surface or a volume may have its numbers.
bool isData(const std::string& name) {
  constexpr std::array<std::string_view, 4> endings{".raw", ".zraw", ".gz", ".bin"};
  const std::string extension = fs::path(name).extension().string();
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view ending) {
    return equalsIgnoringCase(extension, ending);
  });
}

bool isWanted(const std::string& name) {
  return isSurfaceFile(name) || isFiducialFile(name) || isData(name);
}

std::ptrdiff_t depthOf(const std::string& name) {
  return std::count(name.begin(), name.end(), '/');
}

Status unpack(const ZipReader& zip, const ZipReader::Entry& entry, const fs::path& folder) {
  const fs::path target = folder / fs::path(entry.name);
  const std::string bytes = TRY(zip.read(entry));
  std::error_code fault;
  fs::create_directories(target.parent_path(), fault);
  const Status written =
      fault ? Status(Error{.reason = fault.message()}) : writeText(target, bytes);
  if (!written)
    return Error{.where = entry.name,
                 .reason = "it cannot be unpacked: " + written.error().reason,
                 .remedy =
                     "Make room in the folder for temporary files, or name another in "
                     "TMPDIR"};
  return Unit{};
}

}  // namespace

Result<SlicerBundle> unpackBundle(const fs::path& file, const ReadLimits& limits) {
  const std::string bytes = TRY(readText(file, std::size_t(limits.fileBytes)));
  const Result<ZipReader> zip = ZipReader::open(bytes, bundleLimits);
  if (!zip)
    return of(file, zip.error());
  const ZipReader::Entry* scene = nullptr;
  for (const ZipReader::Entry& entry : zip->entries())
    if (isScene(entry.name) && (!scene || depthOf(entry.name) < depthOf(scene->name)))
      scene = &entry;
  if (!scene)
    return of(file, {.reason = "it is a ZIP file, but holds no 3D Slicer scene (.mrml)"});
  TemporaryFolder folder = TRY(TemporaryFolder::create());
  for (const ZipReader::Entry& entry : zip->entries()) {
    if (&entry != scene && !isWanted(entry.name))
      continue;
    if (const Status unpacked = unpack(*zip, entry, folder.path()); !unpacked)
      return of(file, unpacked.error());
  }
  fs::path place = folder.path() / fs::path(scene->name);
  return SlicerBundle{std::move(folder), std::move(place)};
}

}  // namespace sline::model
