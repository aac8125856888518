// SPDX-License-Identifier: Apache-2.0
#include "light_gradient.glsl"
#include "place.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 shapeA;  // F_c·S as symmetric matrix: xx, yy, zz, xy
layout(location = 3) in vec2 shapeB;  // xz, yz

uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec4 layer;
uniform vec4 eye;          // position and 1, or for a parallel projection direction and 0
uniform float shapeScale;  // what a stored 1 stands for
uniform float filigree;    // F_c in mm
uniform vec4 grid;         // a corner of it, and c_s, in mm

out vec3 gridPosition;  // in cells
out vec3 clipPosition;  // x, y and w, of the whole picture
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
