// SPDX-License-Identifier: Apache-2.0
// Makes the surface around all voxels that have an intensity within bounds.
#pragma once

#include <string>
#include <vector>

#include "model/import/source/raw_mesh.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/grey_volume.h"

namespace sline::model {

struct ThresholdSurface {
  RawMesh mesh;                    ///< RawMesh::threshold holds the resolved bounds
  std::vector<std::string> notes;  ///< says which pieces were left out of it and why
};

/// Returns one closed, outward oriented, manifold surface in the volume's own frame, as
/// labelSurfaces makes it of a mask; each vertex lies in the mean of where intensities cross the
/// bounds on the edges around it, and is then relaxed within its cell. `options.smoothing` says how
/// often; `off` leaves it where it is. Pieces are left out that are smaller than the specks of the
/// preset of the threshold's name and than a thousandth of the largest piece. Errors: no bounds
/// (threshold_presets.h), nothing within them, those of labelSurfaces; they name no file.
Result<ThresholdSurface> thresholdSurface(const GreyVolume& volume, const Threshold& threshold,
                                          const ReadOptions& options);

}  // namespace sline::model
