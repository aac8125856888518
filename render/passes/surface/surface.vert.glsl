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

out vec3 surfaceNormal;
out vec3 towardsEye;
#ifdef SECTIONED
out vec3 place;
#endif
out float gradient;  // ⟨k, v̂⟩·F_c

void main() {
  gl_Position = layerClip(viewProjection * vec4(position, 1.0), pictureSize, layer);
#ifdef SECTIONED
  place = position;
#endif
  vec3 toEye = eye.xyz - eye.w * position;
  float away = eye.w / max(length(toEye), 1e-20);
  vec3 v = normalize(toEye);
  vec3 n = normalize(normal.xyz);
  float nv = dot(n, v);
  vec3 w = v - nv * n;
  gradient =
      dot(lightGradient(shapeScale * shapeA, shapeScale * shapeB, w, filigree * nv * away), w);
  surfaceNormal = n;
  towardsEye = v;
}
