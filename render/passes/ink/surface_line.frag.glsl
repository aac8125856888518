// SPDX-License-Identifier: Apache-2.0
// Draws the ink of lines on the surface: suggestive contours, hatching, outlines of cut faces.
#include "capsule.glsl"
#ifdef GRAINED
#include "grain.glsl"
uniform vec2 grain;  // see inkTaken
#endif

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  if (c.distance >= c.halfWidth + 0.5 || !inSight(sightAt(c)))
    discard;
  float coverage = coverageOf(c, lineDepths.z < 0.0 ? -lineDepths.z : 1.0);
#ifdef GRAINED
  coverage *= inkTaken(c.pixel, grain);
#endif
  if (coverage <= 0.002)
    discard;
  fragment = vec4(coverage, 0.0, 0.0, 0.0);
  gl_FragDepth = c.depth;
}
