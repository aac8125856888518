// SPDX-License-Identifier: Apache-2.0
// Draws one capsule per segment, all in pixels of the whole picture; none where its own surface
// hides all of it. Where the pen goes on from one capsule to the next, neither reaches farther than
// the bend asks, so that the ends do not lie over each other.
#include "depth.glsl"
#include "pen.glsl"
#include "place.glsl"
layout(location = 0) in vec4 ends;      // the line itself: a, b
layout(location = 1) in vec4 depths;    // depth at a and b, tolerance in mm, InkVertex::kind
layout(location = 2) in vec4 outwards;  // unit directions across a contour, away from the surface
layout(location = 4) in vec4 moves;     // from a and b to where the pen draws them
layout(location = 3) in vec4 strokes;   // half width at a and b, opacity at a and b
layout(location = 5) in vec3 caps;      // how far the stroke shows beyond a and b at most, px; steps

uniform vec4 layer;
uniform vec4 projection;    // see depth.glsl
uniform isampler2D sights;  // see sight.frag.glsl
uniform int first;          // the first instance's stroke

flat out vec4 drawnEnds;
flat out vec4 strokeEnds;
flat out vec4 lineDepths;
flat out vec4 lineOutwards;
flat out vec4 lineStrokes;
flat out ivec2 lineSight;

void main() {
  int stroke = first + gl_InstanceID;
  lineSight = ivec2(texelFetch(sights, ivec2(stroke & 255, stroke >> 8), 0).r, int(caps.z));
  drawnEnds = ends + moves;
  float middle = 0.5 * (depths.x + depths.y);
  lineDepths = vec4(depths.xyw, depthLift(middle, 2.0 * depths.z, projection));
  lineOutwards = outwards;
  lineStrokes = strokes;
  // S eq. 1: the stroke lies outside the contour, not across it.
  vec2 outside = vec2(penOutside(strokes.x), penOutside(strokes.y));
  strokeEnds = ends + moves + outwards * outside.xxyy;
  vec2 a = strokeEnds.xy;
  vec2 b = strokeEnds.zw;
  float reach = max(strokes.x, strokes.y) + 0.5;
  vec2 along = b - a;
  float lengthAB = length(along);
  along = lengthAB > 1e-6 ? along / lengthAB : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x) * ((gl_VertexID & 1) == 0 ? -reach : reach);
  vec2 beyond = min(caps.xy, vec2(reach));
  vec2 corner = (gl_VertexID & 2) == 0 ? a - along * beyond.x : b + along * beyond.y;
  bool hidden = (lineSight.x & 0xffff) == 0;
  gl_Position = hidden ? vec4(2.0, 2.0, 0.0, 1.0)
                       : vec4(layerPosition(corner + across, layer), 0.0, 1.0);
}
