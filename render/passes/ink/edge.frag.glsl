// SPDX-License-Identifier: Apache-2.0
// Draws the soft edges of a fill, in its own colour.
#include "capsule.glsl"
#include "outside.glsl"
#include "shaded_colour.glsl"
uniform vec4 paint;  // the fill's colour and opacity
uniform vec3 key;    // towards the key light, x and y in the picture; 0: there is none

void main() {
  Capsule c = capsuleAt(gl_FragCoord.xy - vec2(toAtlas));
  if (c.distance >= c.halfWidth + 0.5 || !inSight(sightAt(c)))
    discard;
  float coverage = coverageOf(c, 1.0);
  // The rasteriser's own pixels are already covered; only the fringe outside remains.
  if (coverage <= 0.002 || depthAt(c.pixel) <= c.depth)
    discard;
  coverage *= paint.a;
  // At its contour a surface's normal lies in the picture, across the line.
  vec3 shade = key != vec3(0.0)
      ? shadedColour(paint.rgb, keyLight(0.1, dot(outwardAt(c.t), key.xy) + 0.1 * key.z), 0.0)
      : shadedColour(paint.rgb, headlight(0.1), highlight(0.1));
  fragment = vec4(min(shade, 1.0) * coverage, coverage);
  gl_FragDepth = c.depth;
}
