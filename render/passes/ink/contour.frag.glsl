// SPDX-License-Identifier: Apache-2.0
// Draws the ink of contours, outside the surface's own line (S eq. 1).
#include "capsule.glsl"
#include "contour_visibility.glsl"
#ifdef GRAINED
#include "grain.glsl"
#endif
uniform vec2 channel;  // which of the ink's values is written
uniform float probe;  // distance outside (px) at which the own mask means an inner contour

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  if (c.distance >= c.halfWidth + 0.5)
    discard;
  vec2 outward = outwardAt(c.t);
  float wide;
  if (!contourVisible(c, outward, wide))
    discard;
  float inner = lineDepths.w - 1.0;  // share that remains within the surface's own mask
  if (inner < 1.0) {
    bool within = depthAt(c.on + (wide + probe) * outward) < 1.0 ||
        (depthAt(c.pixel) < 1.0 && length(c.pixel - c.place) > surfaceStep);
    if (within) {
      // Thinner strokes keep one pixel and lose opacity instead.
      float thin = c.halfWidth * inner;
      c.opacity *= min(1.0, thin * 2.0);
      c.halfWidth = max(thin, 0.5);
      c.distance = length(c.pixel - c.place - outward * (c.halfWidth - 0.5));
    }
  }
  float coverage = coverageOf(c, 1.0);
#ifdef GRAINED
  coverage *= grained(c.pixel);
#endif
  if (coverage <= 0.002)
    discard;
  fragment = vec4(channel * coverage, 0.0, 0.0);
  // A neighbour that touches the surface along its contour lies as deep as the line, and by a hair
  // in front of it on the line's outer side: within the tolerance for its own surface, it hides
  // nothing.
  gl_FragDepth = clamp(c.depth - lineLifts.x, 0.0, c.depth);
}
