// SPDX-License-Identifier: Apache-2.0
// Draws the ink of lines on the surface: suggestive contours, hatching, outlines of cut faces.
#include "capsule.glsl"
#ifdef GRAINED
#include "grain.glsl"
#endif

bool surfaceLineVisible(Capsule c) {
  vec2 corner = c.on - 0.5 * surfaceStep;
  vec2 next = vec2(surfaceStep, 0.0);
  float behind = max(max(depthAt(corner), depthAt(corner + next.xy)),
                     max(depthAt(corner + next.yx), depthAt(corner + next.xx)));
  return inSight(c, behind);
}

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  if (c.distance >= c.halfWidth + 0.5 || !surfaceLineVisible(c))
    discard;
  float coverage = coverageOf(c, lineDepths.w < 0.0 ? -lineDepths.w : 1.0);
#ifdef GRAINED
  coverage *= grained(c.pixel);
#endif
  if (coverage <= 0.002)
    discard;
  fragment = vec4(coverage, 0.0, 0.0, 0.0);
  gl_FragDepth = c.depth;
}
