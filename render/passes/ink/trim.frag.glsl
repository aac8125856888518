// SPDX-License-Identifier: Apache-2.0
// Trims a fill that was enlarged along its contours: what lies outside becomes clear.
in vec4 outside;
in float away;

#include "surface_depth.glsl"
uniform ivec4 slot;
uniform ivec2 toAtlas;

out vec4 fragment;

bool surfaceAt(vec2 pixel) {
  return surfaceDepthAt(pixel, Slot(slot, toAtlas)) < 1.0;
}

void main() {
  if (surfaceAt(outside.xy) || surfaceAt(outside.zw))
    discard;
  fragment = vec4(0.0, 0.0, 0.0, clamp(away + 0.5, 0.0, 1.0));
}
