// SPDX-License-Identifier: Apache-2.0
// Draws the ink of contours, outside the surface's own line (S eq. 1).
#include "capsule.glsl"
#include "outside.glsl"
#ifdef GRAINED
#include "grain.glsl"
uniform vec2 grain;  // see inkTaken
#endif
flat in vec4 drawnEnds;  // where the pen draws the line itself
uniform vec2 channel;  // which of the ink's values is written

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  int sight = sightAt(c);
  if (c.distance >= c.halfWidth + 0.5 || !inSight(sight))
    discard;
  float inner = lineDepths.z - 1.0;  // share that remains within the surface's own mask
  if (inner < 1.0) {
    vec2 place = mix(drawnEnds.xy, drawnEnds.zw, c.t);
    if ((sight & 0x10000) != 0 ||
        (depthAt(c.pixel) < 1.0 && length(c.pixel - place) > surfaceStep)) {
      float thin = c.halfWidth * inner;
      c.opacity *= penOpacity(thin);
      c.halfWidth = penHalfWidth(thin);
      c.distance = length(c.pixel - place - outwardAt(c.t) * penOutside(c.halfWidth));
    }
  }
  float coverage = coverageOf(c, 1.0);
#ifdef GRAINED
  coverage *= inkTaken(c.pixel, grain);
#endif
  if (coverage <= 0.002)
    discard;
  fragment = vec4(channel * coverage, 0.0, 0.0);
  // A neighbour that touches the surface along its contour lies as deep as the line, and by a hair
  // in front of it on the line's outer side: within the tolerance for its own surface, it hides
  // nothing.
  gl_FragDepth = clamp(c.depth - lineDepths.w, 0.0, c.depth);
}
