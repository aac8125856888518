// SPDX-License-Identifier: Apache-2.0
// Draws a strip along the outer side of each segment of a contour.
#include "place.glsl"
layout(location = 0) in vec4 ends;      // as in ink.vert.glsl
layout(location = 2) in vec4 outwards;

uniform vec4 layer;
uniform float surfaceStep;

out vec4 outside;  // two places without any surface, if it ends at the contour
out float away;    // from the contour, px

void main() {
  vec2 end = (gl_VertexID & 2) == 0 ? ends.xy : ends.zw;
  vec2 outward = (gl_VertexID & 2) == 0 ? outwards.xy : outwards.zw;
  away = (gl_VertexID & 1) == 0 ? -0.5 : surfaceStep + 0.5;
  // The middle of a coarse pixel is closer than 0.71 steps to any place in it.
  outside = end.xyxy + vec4(0.75, 0.75, 1.5, 1.5) * surfaceStep * outward.xyxy + 0.5 * outward.xyxy;
  gl_Position = vec4(layerPosition(end + away * outward, layer), 0.0, 1.0);
}
