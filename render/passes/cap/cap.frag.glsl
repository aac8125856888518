// SPDX-License-Identifier: Apache-2.0
// Draws a cut face in one flat colour, hatched where requested. Depth comes from the plane itself
// and not from triangles, so that faces of several structures on one plane lie exactly equally
// deep.
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
  float perPixel = max(length(vec2(dFdx(stripe), dFdy(stripe))), 1e-6);
  float nearest = floor(stripe + 0.5);
  bool odd = mod(nearest, 2.0) > 0.5;
  float width = halfWidth * (odd ? stripes.w : 1.0);
  float distance = abs(stripe - nearest) / perPixel;
  // Strokes never become thinner than one pixel; they lose opacity instead (METHOD §4).
  return clamp(max(width, 0.5) + 0.5 - distance, 0.0, 1.0) * min(1.0, 2.0 * width);
}

void main() {
  float coverage = strokeColour.a > 0.0 ? strokeCoverage() : 0.0;
  if (cutAway(place))
    discard;
  fragment = mix(colour, strokeColour, coverage);
  gl_FragDepth = clamp(dot(depthPlane, vec3(pixelStep * gl_FragCoord.xy + toMiddle, 1.0)), 0.0, 1.0);
}
