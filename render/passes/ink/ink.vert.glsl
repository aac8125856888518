// SPDX-License-Identifier: Apache-2.0
// Draws one capsule per segment, all in pixels of the whole picture.
#include "place.glsl"
layout(location = 0) in vec4 ends;      // the line itself: a, b
layout(location = 1) in vec4 depths;    // depth at a and b, tolerance in mm, InkVertex::kind
layout(location = 2) in vec4 outwards;  // unit directions across a contour, away from the surface
layout(location = 4) in vec4 moves;     // from a and b to where the pen draws them
layout(location = 3) in vec4 strokes;   // half width at a and b, opacity at a and b

uniform vec4 layer;

flat out vec4 lineEnds;
flat out vec4 drawnEnds;
flat out vec4 strokeEnds;
flat out vec4 lineDepths;
flat out vec4 lineOutwards;
flat out vec4 lineStrokes;

void main() {
  lineEnds = ends;
  drawnEnds = ends + moves;
  lineDepths = depths;
  lineOutwards = outwards;
  lineStrokes = strokes;
  // S eq. 1: the stroke lies outside the contour, not across it.
  strokeEnds = ends + moves + outwards * max(strokes.xxyy - 0.5, 0.0);
  vec2 a = strokeEnds.xy;
  vec2 b = strokeEnds.zw;
  float reach = max(strokes.x, strokes.y) + 0.5;
  vec2 along = b - a;
  float lengthAB = length(along);
  along = lengthAB > 1e-6 ? along / lengthAB : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) == 0 ? -reach : reach);
  vec2 corner = (gl_VertexID & 2) == 0 ? a - along * reach : b + along * reach;
  gl_Position = vec4(layerPosition(corner + across, layer), 0.0, 1.0);
}
