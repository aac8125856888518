// SPDX-License-Identifier: Apache-2.0
// Resamples a scan on a finer grid where its own is too coarse for smooth surfaces.
#pragma once

#include <functional>
#include <optional>

#include "model/import/volumes/grey_volume.h"

namespace sline::model {

/// Doubles the number of voxels along an axis, again and again: along axes with voxels longer than
/// 1.6 times the shortest side, and along all axes of scans of few voxels. Measured values stay as
/// they are, so that plates of one voxel stay whole; halfway between two voxels lies the cubic
/// through the four around (N. Dyn, D. Levin and J. A. Gregory, CAGD 4(4), 1987), kept between the
/// two. Returns nothing where the grid is fine enough, or too large to be made finer.
std::optional<GreyVolume> refinedScan(const GreyVolume& volume);

}  // namespace sline::model
