// SPDX-License-Identifier: Apache-2.0
// Trims a fill that was enlarged along its contours: what lies outside becomes clear.
#include "surface_depth.glsl"
in vec2 on;
in vec2 outward;
in float away;
in float lineDepth;
flat in vec2 reaches;

uniform ivec4 slot;
uniform ivec2 toAtlas;

out vec4 fragment;

float depthAt(vec2 pixel) {
  return surfaceDepthAt(pixel, Slot(slot, toAtlas));
}

void main() {
  // The middle of a coarse pixel is closer than 0.71 steps to any place in it.
  float near = 0.75 * surfaceStep + 0.5;
  float far = 1.5 * surfaceStep + 0.5;
  // What is nearer hides the contour.
  if (away <= -0.5 || depthAt(on + away * outward) < lineDepth - reaches.y ||
      depthAt(on + near * outward) < 1.0 || depthAt(on + far * outward) < 1.0)
    discard;
  fragment = vec4(0.0, 0.0, 0.0, clamp(away + 0.5, 0.0, 1.0));
}
