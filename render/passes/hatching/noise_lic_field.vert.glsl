// SPDX-License-Identifier: Apache-2.0
#include "place.glsl"
#include "shaped_surface.glsl"
uniform vec4 grid;  // the middle of the surface, and the size of a cell of noise, in mm

out vec3 noisePosition;  // in cells
out vec3 clipPosition;   // x, y and w in the whole picture
out vec3 surfaceNormal;
out vec3 towardsEye;
out vec4 scaledShapeA;  // F_c·S: xx, yy, zz, xy
out vec2 scaledShapeB;  // xz, yz

void main() {
  vec4 clip = viewProjection * vec4(position, 1.0);
  gl_Position = layerClip(clip, pictureSize, layer);
  clipPosition = clip.xyw;
  noisePosition = (position - grid.xyz) / grid.w;
  surfaceNormal = normalize(normal.xyz);
  towardsEye = normalize(eye.xyz - eye.w * position);
  scaledShapeA = shapeScale * shapeA;
  scaledShapeB = shapeScale * shapeB;
}
