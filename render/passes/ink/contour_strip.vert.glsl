// SPDX-License-Identifier: Apache-2.0
// Draws a strip on both sides of each segment of a contour.
#include "depth.glsl"
#include "place.glsl"
layout(location = 0) in vec4 ends;  // as in ink.vert.glsl
layout(location = 1) in vec4 depths;
layout(location = 2) in vec4 outwards;

uniform vec4 layer;
uniform vec4 projection;  // see depth.glsl
uniform float reach;      // px to each side
uniform float sheetInMm;  // see InkDraw::sheet

out vec2 on;            // the place of the contour
out vec2 outward;
out float away;         // from the contour, px, outwards
out float lineDepth;
flat out vec2 reaches;  // by which the surface's depth may differ: farther, nearer

void main() {
  bool first = (gl_VertexID & 2) == 0;
  on = first ? ends.xy : ends.zw;
  outward = first ? outwards.xy : outwards.zw;
  lineDepth = first ? depths.x : depths.y;
  away = (gl_VertexID & 1) == 0 ? -reach : reach;
  float middle = 0.5 * (depths.x + depths.y);
  reaches = vec2(depthLift(middle, depths.z, projection), depthLift(middle, sheetInMm, projection));
  gl_Position = vec4(layerPosition(on + away * outward, layer), 0.0, 1.0);
}
