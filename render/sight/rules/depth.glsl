// SPDX-License-Identifier: Apache-2.0
// How window depths and distances from the eye belong together (METHOD §4). See rules.h for what may
// be written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif

// Returns the distance in millimetres from the eye's plane to a window depth in 0 … 1. `projection`
// holds the projection matrix' entries [2][2], [3][2], [2][3] and [3][3] (column, row), so that one
// formula serves perspective and parallel projections.
RULE float eyeDistance(float windowDepth, vec4 projection) {
  float z = 2.0f * windowDepth - 1.0f;
  return (projection.y - z * projection.w) / (projection.x - z * projection.z);
}

// Returns the distance of what lies nearer to the eye by so many millimetres: in perspective not
// behind the eye.
RULE float liftedDistance(float from, float mm, float perspective) {
  return perspective != 0.0f ? max(from - mm, 1e-3f * from) : from - mm;
}

// Returns by how much window depth falls where a point comes nearer to the eye by so many
// millimetres.
RULE float depthLift(float windowDepth, float mm, vec4 projection) {
  float to = liftedDistance(eyeDistance(windowDepth, projection), mm, projection.z);
  float z = (projection.y - to * projection.x) / (projection.w - to * projection.z);
  return windowDepth - (0.5f * z + 0.5f);
}
