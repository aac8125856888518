// SPDX-License-Identifier: Apache-2.0
// Analytic coverage of a capsule, kept where its own surface does not hide the line (METHOD §4).
// The line is looked up at its point nearest to the pixel, so a stroke is hidden or shown across its
// whole width.
#include "depth.glsl"
#include "phong.glsl"
flat in vec4 lineEnds;
flat in vec4 strokeEnds;
flat in vec4 lineDepths;
flat in vec4 lineOutwards;
flat in vec4 lineStrokes;

uniform sampler2D surfaceDepth;
uniform ivec4 slot;        // of the layer in the atlas: first and last pixel
uniform ivec2 toAtlas;     // from picture pixels to atlas pixels
uniform vec4 projection;   // see depth.glsl
uniform float probe;       // how far outside (px) the own mask means an inner contour
uniform vec2 reach;        // px at which a contour's far side is looked for: a step, a wide one
uniform float sheet;       // mm by which a surface may hide a line of its own sheet
uniform int edges;         // 1: soft edges of a fill in its own colour instead of ink
uniform vec4 paint;        // the fill's colour and opacity; for edges only
uniform vec3 key;          // towards the key light, x and y in the picture; 0: there is none

out vec4 fragment;

float depthAt(vec2 pixel) {
  ivec2 texel = ivec2(floor(pixel)) + toAtlas;
  if (any(lessThan(texel, slot.xy)) || any(greaterThan(texel, slot.zw)))
    return 1.0;
  return texelFetch(surfaceDepth, texel, 0).r;
}

// Within a step of a contour its own surface falls away from the eye or ends; a hidden contour has
// something nearer on both sides. Where a surface is seen along its length, its triangles' outline
// may lie a few pixels outside of the line: there, and only if what hides the line is the same
// sheet, a wider step counts.
bool contourVisible(vec2 c, vec2 outward, float depth, out float wide) {
  wide = 0.0;
  float here = depthAt(c);
  float behind = max(here, depthAt(c + reach.x * outward));
  float distance = eyeDistance(depth, projection);
  if (distance <= eyeDistance(behind, projection) + lineDepths.z)
    return true;
  if (distance > eyeDistance(here, projection) + sheet)
    return false;
  wide = reach.y;
  behind = max(depthAt(c + 0.5 * (reach.x + reach.y) * outward), depthAt(c + reach.y * outward));
  return distance <= eyeDistance(behind, projection) + lineDepths.z;
}

bool surfaceLineVisible(vec2 c, float depth) {
  vec2 corner = c - 0.5;
  float behind = max(max(depthAt(corner), depthAt(corner + vec2(1.0, 0.0))),
                     max(depthAt(corner + vec2(0.0, 1.0)), depthAt(corner + vec2(1.0, 1.0))));
  return depth <= behind ||
      eyeDistance(depth, projection) <= eyeDistance(behind, projection) + lineDepths.z;
}

void main() {
  vec2 pixel = gl_FragCoord.xy - vec2(toAtlas);
  vec2 along = strokeEnds.zw - strokeEnds.xy;
  float t = clamp(dot(pixel - strokeEnds.xy, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  float distance = length(pixel - mix(strokeEnds.xy, strokeEnds.zw, t));
  float halfWidth = mix(lineStrokes.x, lineStrokes.y, t);
  float opacity = mix(lineStrokes.z, lineStrokes.w, t);
  if (distance >= halfWidth + 0.5)
    discard;
  vec2 c = mix(lineEnds.xy, lineEnds.zw, t);
  float depth = mix(lineDepths.x, lineDepths.y, t);
  if (lineDepths.w > 0.5) {
    vec2 outward = normalize(mix(lineOutwards.xy, lineOutwards.zw, t) + vec2(1e-6, 0.0));
    float wide;
    if (!contourVisible(c, outward, depth, wide))
      discard;
    float inner = lineDepths.w - 1.0;  // how much is left within the surface's own mask
    if (inner < 1.0) {
      bool within = depthAt(c + (wide + probe) * outward) < 1.0 ||
          (depthAt(pixel) < 1.0 && length(pixel - c) > 1.0);
      if (within) {
        // Thinner strokes keep one pixel and lose opacity instead.
        float thin = halfWidth * inner;
        opacity *= min(1.0, thin * 2.0);
        halfWidth = max(thin, 0.5);
        distance = length(pixel - c - outward * (halfWidth - 0.5));
      }
    }
  } else if (!surfaceLineVisible(c, depth)) {
    discard;
  }
  float edge = lineDepths.w < 0.0 ? -lineDepths.w : 1.0;
  float coverage = clamp((halfWidth - distance) / edge + 0.5, 0.0, 1.0) * opacity;
  if (coverage <= 0.002)
    discard;
  if (edges != 0) {
    // The rasteriser's own pixels are covered already; what is left is the fringe outside.
    if (depthAt(pixel) <= depth)
      discard;
    coverage *= paint.a;
    // At its contour a surface's normal lies in the picture, across the line.
    vec2 normal = normalize(mix(lineOutwards.xy, lineOutwards.zw, t) + vec2(1e-6, 0.0));
    vec3 shaded = key != vec3(0.0)
        ? phongWithKey(paint.rgb, 0.1, dot(normal, key.xy) + 0.1 * key.z, 0.0)
        : phong(paint.rgb, 0.1);
    fragment = vec4(min(shaded, 1.0) * coverage, coverage);
  } else {
    fragment = vec4(coverage);
  }
  gl_FragDepth = depth;
}
