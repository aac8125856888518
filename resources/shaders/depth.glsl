// SPDX-License-Identifier: Apache-2.0
// Returns the distance in millimetres from the eye's plane to a window depth in 0 … 1. `projection`
// holds the projection matrix' entries [2][2], [3][2], [2][3] and [3][3] (column, row), so that one
// formula serves perspective and parallel projections.
float eyeDistance(float windowDepth, vec4 projection) {
  float z = 2.0 * windowDepth - 1.0;
  return (projection.y - z * projection.w) / (projection.x - z * projection.z);
}
