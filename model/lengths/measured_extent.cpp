// SPDX-License-Identifier: Apache-2.0
#include "model/lengths/measured_extent.h"

namespace sline::model {

bool isAsRead(const Provenance& p) {
  return p.smoothingSteps == 0 && p.refinementSteps == 0 && p.displacementMm == 0.0f &&
         p.decimatedFrom == 0;
}

float movedMm(const Provenance& p) {
  return p.displacementMm + (p.decimatedFrom > 0 ? p.decimationMm : 0.0f);
}

MeasuredExtent measuredExtent(const Node& structure) {
  const bool same = isAsRead(structure.provenance);
  MeasuredExtent measured{extentOf(*structure.mesh), same, same};
  const std::optional<ReadExtent>& before = structure.provenance.asRead;
  if (!before)
    return measured;
  if (before->areaMm2) {
    measured.extent.area = double(*before->areaMm2);
    measured.areaAsRead = true;
  }
  // A surface that was read open has no volume, even where smoothing closed it.
  if (before->volumeMm3 || before->areaMm2) {
    measured.extent.volume = before->volumeMm3;
    measured.volumeAsRead = true;
  }
  return measured;
}

}  // namespace sline::model
