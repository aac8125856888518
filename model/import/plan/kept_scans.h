// SPDX-License-Identifier: Apache-2.0
// Turns scans that were read into scans of the scene.
#pragma once

#include <vector>

#include "model/import/plan/load_parts.h"
#include "model/scene/scan.h"

namespace sline::model {

/// Returns each scan in millimetres LPS: by the frame and unit of the parts that were made of it,
/// where there are some, else by those of the options, else by its own. A scan that cannot be kept
/// becomes a warning.
std::vector<Scan> keptScans(const std::vector<ReadScan>& scans, const std::vector<Part>& parts,
                            const ImportOptions& options, ImportReport& report);

/// Returns "CT, 512 × 512 × 300 voxels of 0.7 × 0.7 × 1 mm, 157.3 MB unpacked".
std::string scanText(const Scan& scan);
/// Returns the same text for a scan of which frame and unit are not decided.
std::string scanText(const GreyVolume& volume);

}  // namespace sline::model
