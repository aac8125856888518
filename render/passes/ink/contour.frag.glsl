// SPDX-License-Identifier: Apache-2.0
// Ink of contours, outside of the surface's own line (S eq. 1).
#include "capsule.glsl"
#include "contour_visibility.glsl"
uniform float probe;  // how far outside (px) the own mask means an inner contour

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  if (c.distance >= c.halfWidth + 0.5)
    discard;
  vec2 outward = outwardAt(c.t);
  float wide;
  if (!contourVisible(c, outward, wide))
    discard;
  float inner = lineDepths.w - 1.0;  // how much is left within the surface's own mask
  if (inner < 1.0) {
    bool within = depthAt(c.on + (wide + probe) * outward) < 1.0 ||
        (depthAt(c.pixel) < 1.0 && length(c.pixel - c.on) > 1.0);
    if (within) {
      // Thinner strokes keep one pixel and lose opacity instead.
      float thin = c.halfWidth * inner;
      c.opacity *= min(1.0, thin * 2.0);
      c.halfWidth = max(thin, 0.5);
      c.distance = length(c.pixel - c.on - outward * (c.halfWidth - 0.5));
    }
  }
  float coverage = coverageOf(c, 1.0);
  if (coverage <= 0.002)
    discard;
  fragment = vec4(coverage);
  gl_FragDepth = c.depth;
}
