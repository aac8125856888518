// SPDX-License-Identifier: Apache-2.0
// Holds what the kinds of capsules share: where a pixel lies relative to its stroke, and
// their own surface. Each kind has a program of its own, as software rasterisers look up every
// texture of every branch.
flat in vec4 lineEnds;
flat in vec4 drawnEnds;
flat in vec4 strokeEnds;
flat in vec4 lineDepths;  // depth at a and b, what the tolerance is in depth, InkVertex::kind
flat in vec4 lineOutwards;
flat in vec4 lineStrokes;

uniform sampler2D surfaceDepth;
uniform float surfaceStep;  // px for one of surfaceDepth, each way
uniform ivec4 slot;       // the layer's place in the atlas: first and last pixel
uniform ivec2 toAtlas;    // from picture pixels to atlas pixels

out vec4 fragment;

// The line is looked up at its point nearest to the pixel, so a stroke is hidden or shown across
// its whole width.
struct Capsule {
  vec2 pixel;
  vec2 on;         // the line's nearest point
  vec2 place;      // where the pen draws it
  float depth;     // of that point
  float distance;  // from the stroke's middle, px
  float halfWidth;
  float opacity;
  float t;
};

Capsule capsuleAt(vec2 pixel) {
  vec2 along = strokeEnds.zw - strokeEnds.xy;
  float t = clamp(dot(pixel - strokeEnds.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  return Capsule(pixel, mix(lineEnds.xy, lineEnds.zw, t),
                 mix(drawnEnds.xy, drawnEnds.zw, t), mix(lineDepths.x, lineDepths.y, t),
                 length(pixel - mix(strokeEnds.xy, strokeEnds.zw, t)),
                 mix(lineStrokes.x, lineStrokes.y, t), mix(lineStrokes.z, lineStrokes.w, t), t);
}

vec2 outwardAt(float t) {
  return normalize(mix(lineOutwards.xy, lineOutwards.zw, t) + vec2(1e-6, 0.0));
}

float depthAt(vec2 pixel) {
  ivec2 texel = ivec2(floor(pixel)) + toAtlas;
  if (any(lessThan(texel, slot.xy)) || any(greaterThan(texel, slot.zw)))
    return 1.0;
  return texelFetch(surfaceDepth, ivec2((vec2(texel) + 0.5) / surfaceStep), 0).r;
}

// Tells whether a surface of that depth leaves the line in sight.
bool inSight(Capsule c, float surface) {
  return c.depth - lineDepths.z <= surface;
}

// Returns the analytic coverage (METHOD §4), softened over `edge` pixels.
float coverageOf(Capsule c, float edge) {
  return clamp((c.halfWidth - c.distance) / edge + 0.5, 0.0, 1.0) * c.opacity;
}
