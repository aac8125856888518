// SPDX-License-Identifier: Apache-2.0
// Reads 3D Slicer's bundle (.mrb): one ZIP with a scene and all the files that it refers to.
#pragma once

#include <filesystem>

#include "model/disk/temporary_folder.h"
#include "model/import/source/read_options.h"

namespace sline::model {

struct SlicerBundle {
  TemporaryFolder folder;
  std::filesystem::path scene;  ///< the .mrml in it
};

/// Unpacks the files that a scene may need into a folder that is deleted with the value. Refuses
/// what ZipReader refuses, and a bundle without a scene; of several scenes the outermost is taken,
/// and of these the first by name.
Result<SlicerBundle> unpackBundle(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
