// SPDX-License-Identifier: Apache-2.0
#include "light_gradient.glsl"
#include "place.glsl"
#include "shaped_surface.glsl"

out vec3 surfaceNormal;
out vec3 towardsEye;
#ifdef SECTIONED
out vec3 place;
#endif
out float gradient;  // ⟨k, v̂⟩·F_c
#ifdef GAMMA_VARIES
layout(location = 4) in float gammaOffset;
out float offset;
#endif

void main() {
  gl_Position = layerClip(viewProjection * vec4(position, 1.0), pictureSize, layer);
#ifdef SECTIONED
  place = position;
#endif
#ifdef GAMMA_VARIES
  offset = gammaOffset;
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
