// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/image_pair.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include "model/base/letters.h"
#include "model/import/source/packed_bytes.h"
#include "model/import/source/text_cursor.h"
#include "model/import/source/values.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Holds a name in its parts: "brain", ".HDR", ".gz".
struct PairName {
  fs::path stem;  ///< with its folder
  std::string ending;
  bool header = false;
};

std::optional<PairName> pairName(const fs::path& file) {
  fs::path name = file;
  if (equalsIgnoringCase(name.extension().string(), ".gz"))
    name.replace_extension();
  PairName found{fs::path(name).replace_extension(), name.extension().string()};
  found.header = equalsIgnoringCase(found.ending, ".hdr");
  if (!found.header && !equalsIgnoringCase(found.ending, ".img"))
    return std::nullopt;
  return found;
}

/// Returns the other ending, in capitals where this one is.
std::string otherEnding(const PairName& name) {
  const bool capitals = name.ending[1] >= 'A' && name.ending[1] <= 'Z';
  return name.header ? (capitals ? ".IMG" : ".img") : (capitals ? ".HDR" : ".hdr");
}

/// Tells whether the file begins like a header: either kind begins with its length, in either byte
/// order.
bool beginsLikeHeader(const fs::path& file) {
  std::array<char, 512> bytes{};
  std::FILE* handle = std::fopen(file.string().c_str(), "rb");
  if (!handle)
    return false;
  const std::size_t size = std::fread(bytes.data(), 1, bytes.size(), handle);
  std::fclose(handle);
  const std::string_view stored(bytes.data(), size);
  PackedBytes unpacked(stored, beginsLikeGzip(stored) ? Packing::deflated : Packing::none);
  std::array<char, 4> first{};
  if (unpacked.read(first.data(), first.size()) != first.size())
    return false;
  for (const bool swap : {false, true})
    for (const std::int32_t length : {348, 540})
      if (loadAs<std::int32_t>(first.data(), swap) == length)
        return true;
  return false;
}

}  // namespace

bool isOfImagePair(const fs::path& file) {
  return pairName(file).has_value();
}

Result<ImagePair> imagePairOf(const fs::path& file) {
  const std::optional<PairName> name = pairName(file);
  if (!name)
    return Error{file.string(), {}, "is called neither .hdr nor .img", "Check the name"};
  const fs::path other = name->stem.string() + otherEnding(*name);
  std::error_code fault;
  for (const char* packing : {"", ".gz", ".GZ"}) {
    const fs::path candidate = other.string() + packing;
    if (fs::is_regular_file(candidate, fault))
      return name->header ? ImagePair{file, candidate} : ImagePair{candidate, file};
  }
  return Error{file.string(),
               {},
               std::string(name->header ? "has its voxels" : "has its header") + " in " +
                   other.filename().string() + ", which is not beside it",
               "Put both files into one folder, or export the volume as one .nii file"};
}

bool isImagePair(const fs::path& file) {
  const Result<ImagePair> pair = imagePairOf(file);
  return pair && beginsLikeHeader(pair->header);
}

}  // namespace sline::model
