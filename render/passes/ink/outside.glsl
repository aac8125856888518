// SPDX-License-Identifier: Apache-2.0
// Holds what capsules outside a surface's contour share; for capsule.glsl.
#include "surface_depth.glsl"
flat in vec4 lineOutwards;
uniform ivec4 slot;  // the layer's place in the atlas: first and last pixel

vec2 outwardAt(float t) {
  return normalize(mix(lineOutwards.xy, lineOutwards.zw, t) + vec2(1e-6, 0.0));
}

float depthAt(vec2 pixel) {
  return surfaceDepthAt(pixel, Slot(slot, toAtlas));
}
