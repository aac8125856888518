// SPDX-License-Identifier: Apache-2.0
// Marks the strip beside an outline where lines behind it stop (METHOD §11.6).
#include "capsule.glsl"
#include "outside.glsl"

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  // Within its own mask a structure's fill and lines are as they would be without a halo.
  if (c.distance >= c.halfWidth || !inSight(sightAt(c)) || depthAt(c.pixel) < 1.0)
    discard;
  fragment = vec4(0.0, 1.0, 0.0, 0.0);
  gl_FragDepth = c.depth;
}
