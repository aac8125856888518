// SPDX-License-Identifier: Apache-2.0
// Finds volumes that have header and voxels in two files: STEM.hdr and STEM.img, as Analyze has
// them and NIfTI may. Other programs use both endings for other things.
#pragma once

#include <filesystem>

#include "model/base/result.h"

namespace sline::model {

struct ImagePair {
  std::filesystem::path header;
  std::filesystem::path image;
};

/// Returns true where the name ends in .hdr or .img, packed (.gz) or not.
bool isOfImagePair(const std::filesystem::path& file);

/// Returns both files, whichever of them is named. The other one is looked for beside it, in the
/// same case, packed or not; an error says that it is not there.
Result<ImagePair> imagePairOf(const std::filesystem::path& file);

/// Returns true for either file of a pair that has a header of NIfTI or Analyze by its first bytes.
bool isImagePair(const std::filesystem::path& file);

}  // namespace sline::model
