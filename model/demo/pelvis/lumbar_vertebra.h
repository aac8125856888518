// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/sculpting/sculpture.h"

namespace sline::model {

/// Describes a vertebral body or a disc: a bean in cross-section, flat behind, between two end
/// plates.
struct VertebralBody {
  glm::vec3 centre;
  float tilt;        ///< degrees by which its axis leans forward from the z axis
  float halfWidth;   ///< mm, half the width of its end plates
  float halfDepth;   ///< mm, half of its extent from front to back
  float halfHeight;  ///< mm, half its height in the middle
  float wedge;       ///< mm higher at the front than at the back, half of it above, half below
  float waist;       ///< mm by which it is narrower at half height; negative where it bulges
  float hollow;      ///< mm by which the end plates are hollow; negative where they bulge

  float distance(const glm::vec3& p) const;
  Box bounds() const;
};

/// Models the fifth lumbar vertebra of the pelvis demo and the disc below it (LPS, mm). The disc
/// still overlaps its neighbours a little.
Sculpture fifthLumbarVertebra();
Sculpture lumbosacralDisc();

}  // namespace sline::model
