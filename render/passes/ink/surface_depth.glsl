// SPDX-License-Identifier: Apache-2.0
// Reads how deep a layer's own surface lies.
uniform sampler2D surfaceDepth;
uniform float surfaceStep;  // px for one of surfaceDepth, each way

// A layer's place in the atlas: its first and last pixel, and the way there from picture pixels.
struct Slot {
  ivec4 pixels;
  ivec2 toAtlas;
};

float surfaceDepthAt(vec2 pixel, Slot slot) {
  ivec2 texel = ivec2(floor(pixel)) + slot.toAtlas;
  if (any(lessThan(texel, slot.pixels.xy)) || any(greaterThan(texel, slot.pixels.zw)))
    return 1.0;
  return texelFetch(surfaceDepth, ivec2((vec2(texel) + 0.5) / surfaceStep), 0).r;
}
