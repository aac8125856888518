// SPDX-License-Identifier: Apache-2.0
#include "light_gradient.glsl"
#include "place.glsl"
#include "shaped_surface.glsl"
uniform vec4 grid;         // a corner of the grid, and c_s, in mm

out vec3 gridPosition;  // in cells
out vec3 clipPosition;  // x, y and w in the whole picture
out vec3 surfaceNormal;
out vec3 towardsEye;
out vec3 gradient;  // F_c·k

void main() {
  vec4 clip = viewProjection * vec4(position, 1.0);
  gl_Position = layerClip(clip, pictureSize, layer);
  clipPosition = clip.xyw;
  gridPosition = (position - grid.xyz) / grid.w;
  vec3 toEye = eye.xyz - eye.w * position;
  vec3 v = normalize(toEye);
  vec3 n = normalize(normal.xyz);
  float nv = dot(n, v);
  float away = eye.w / max(length(toEye), 1e-20);
  gradient = lightGradient(shapeScale * shapeA, shapeScale * shapeB, v - nv * n,
                           filigree * nv * away);
  surfaceNormal = n;
  towardsEye = v;
}
