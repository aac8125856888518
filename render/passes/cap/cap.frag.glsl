// SPDX-License-Identifier: Apache-2.0
// Draws a cut face in one flat colour, hatched where requested.
#include "pen.glsl"
#include "sections.glsl"
in vec3 place;

uniform vec4 colour;      // premultiplied
uniform vec4 strokeColour;  // premultiplied; alpha 0: no hatching
uniform vec4 stripes;     // stripe number = ⟨xyz, place⟩; w: share of the odd stripes
uniform float halfWidth;  // px, of a stroke
uniform float pixelStep;  // pixels of the picture for one of the atlas
uniform vec2 toMiddle;    // from these to picture pixels from the picture's middle
uniform vec3 depthPlane;  // window depth = ⟨depthPlane, (x, y, 1)⟩

out vec4 fragment;

// Returns the coverage by strokes, which run along whole stripe numbers.
float strokeCoverage() {
  float stripe = dot(stripes.xyz, place);
  float perPixel = length(vec2(dFdx(stripe), dFdy(stripe)));
  return stripeCoverage(stripe, perPixel, halfWidth, stripes.w);
}

void main() {
  float coverage = strokeColour.a > 0.0 ? strokeCoverage() : 0.0;
  if (cutAway(place))
    discard;
  fragment = mix(colour, strokeColour, coverage);
  gl_FragDepth = faceDepth(depthPlane, pixelStep * gl_FragCoord.xy + toMiddle);
}
