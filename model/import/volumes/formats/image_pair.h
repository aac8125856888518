// SPDX-License-Identifier: Apache-2.0
// Volumes whose header and voxels are two files: STEM.hdr and STEM.img, as Analyze has them and
// NIfTI may. Other programs use both endings for other things.
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

struct ImagePair {
  std::filesystem::path header;
  std::filesystem::path image;
};

/// True where the name ends in .hdr or .img, packed (.gz) or not.
bool isOfImagePair(const std::filesystem::path& file);

/// Both files, whichever of them is named. The other one is looked for beside it, in the same case,
/// packed or not; an error says that it is not there.
Result<ImagePair> imagePairOf(const std::filesystem::path& file);

/// True for either file of a pair whose header is one of NIfTI or Analyze by its first bytes.
bool isImagePair(const std::filesystem::path& file);

}  // namespace sline::model
