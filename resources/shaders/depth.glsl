// SPDX-License-Identifier: Apache-2.0
// Returns the distance in millimetres from the eye's plane to a window depth in 0 … 1. `projection`
// holds the projection matrix' entries [2][2], [3][2], [2][3] and [3][3] (column, row), so that one
// formula serves perspective and parallel projections.
float eyeDistance(float windowDepth, vec4 projection) {
  float z = 2.0 * windowDepth - 1.0;
  return (projection.y - z * projection.w) / (projection.x - z * projection.z);
}

// Returns by how much window depth falls where a point comes nearer to the eye by so many
// millimetres.
float depthLift(float windowDepth, float mm, vec4 projection) {
  float from = eyeDistance(windowDepth, projection);
  float to = from - mm;
  if (projection.z != 0.0)
    to = max(to, 1e-3 * from);  // in perspective not behind the eye
  float z = (projection.y - to * projection.x) / (projection.w - to * projection.z);
  return windowDepth - (0.5 * z + 0.5);
}
