// SPDX-License-Identifier: Apache-2.0
// Fills a surface that was enlarged up to its contours, and shows what lies behind outside of them:
// there enlarging has mixed both, and its border runs from sample to sample.
#include "enlarged.glsl"
in vec2 on;
in vec2 outward;
in float away;
in float lineDepth;
flat in vec2 reaches;

uniform ivec4 slot;  // the layer's place in the atlas: first and last pixel
uniform ivec2 toAtlas;

out vec4 fragment;

// Returns the sample at a pixel: (−1, 0) outside the layer.
ivec2 sampleAt(vec2 pixel) {
  ivec2 texel = ivec2(floor(pixel)) + toAtlas;
  if (any(lessThan(texel, slot.xy)) || any(greaterThan(texel, slot.zw)))
    return ivec2(-1, 0);
  return ivec2((vec2(texel) + 0.5) / pixelStep);
}

float depthOf(ivec2 at) {
  return at.x < 0 ? 1.0 : texelFetch(depths, at, 0).r;
}

// Returns a sample of the surface within the contour, from near the contour on.
ivec2 sampleWithin() {
  for (int k = 0; k < 4; ++k) {
    float steps = k < 3 ? 0.5 * float(k + 1) : 2.25;
    ivec2 at = sampleAt(on - steps * pixelStep * outward);
    float found = depthOf(at);
    if (found <= lineDepth + reaches.x && found >= lineDepth - reaches.y)
      return at;
  }
  return ivec2(-1, 0);
}

// Returns a sample of what lies behind the contour.
ivec2 sampleBehind(float known) {
  for (int k = 1; k < 3; ++k) {
    ivec2 at = sampleAt(on + (0.75 * float(k) * pixelStep + 0.5) * outward);
    float found = depthOf(at);
    if (found > lineDepth + reaches.x)
      return found < 1.0 && found > known ? at : ivec2(-1, 0);
  }
  return ivec2(-1, 0);
}

void main() {
  float known = enlargedAt(gl_FragCoord.xy).depth;
  bool within = away <= 0.0;
  // What is nearer hides the contour, and most is the surface as it should be.
  if (known < lineDepth - reaches.y || (within ? known <= lineDepth + reaches.x : known >= 1.0))
    discard;
  ivec2 at = within ? sampleWithin() : sampleBehind(known);
  if (at.x < 0)
    discard;
  fragment = texelFetch(colours, at, 0);
  gl_FragDepth = within ? lineDepth + reaches.x : depthOf(at);
}
