// SPDX-License-Identifier: Apache-2.0
// Holds what the kinds of capsules share: where a pixel lies relative to its stroke, and what is in
// sight there (sight.frag.glsl). Each kind has a program of its own, as software rasterisers look
// up every texture of every branch.
#include "pen.glsl"
flat in vec4 strokeEnds;
flat in vec4 lineDepths;  // depth at a and b, InkVertex::kind, window depth of twice the tolerance
flat in vec4 lineStrokes;
flat in ivec2 lineSight;  // the bits, and the last place's number

uniform ivec2 toAtlas;  // from picture pixels to atlas pixels

out vec4 fragment;

// The line is looked up at its point nearest to the pixel, so a stroke is hidden or shown across
// its whole width.
struct Capsule {
  vec2 pixel;
  float depth;     // of the line's nearest point
  float distance;  // from the stroke's middle, px
  float halfWidth;
  float opacity;
  float t;
};

Capsule capsuleAt(vec2 pixel) {
  vec2 along = strokeEnds.zw - strokeEnds.xy;
  float t = clamp(dot(pixel - strokeEnds.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  return Capsule(pixel, mix(lineDepths.x, lineDepths.y, t),
                 length(pixel - mix(strokeEnds.xy, strokeEnds.zw, t)),
                 mix(lineStrokes.x, lineStrokes.y, t), mix(lineStrokes.z, lineStrokes.w, t), t);
}

// Returns the bits of the place that is nearest to the capsule's.
int sightAt(Capsule c) {
  return lineSight.x >> int(c.t * float(lineSight.y) + 0.5);
}

bool inSight(int sight) {
  return (sight & 1) != 0;
}

float coverageOf(Capsule c, float edge) {
  return penCoverage(c.halfWidth, c.distance, edge) * c.opacity;
}
