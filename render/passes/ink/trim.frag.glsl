// SPDX-License-Identifier: Apache-2.0
// Trims a fill that was enlarged along its contours: what lies outside becomes clear.
in vec4 outside;
in float away;

uniform sampler2D surfaceDepth;
uniform float surfaceStep;
uniform ivec4 slot;
uniform ivec2 toAtlas;

out vec4 fragment;

bool surfaceAt(vec2 pixel) {
  ivec2 texel = ivec2(floor(pixel)) + toAtlas;
  if (any(lessThan(texel, slot.xy)) || any(greaterThan(texel, slot.zw)))
    return false;
  return texelFetch(surfaceDepth, ivec2((vec2(texel) + 0.5) / surfaceStep), 0).r < 1.0;
}

void main() {
  if (surfaceAt(outside.xy) || surfaceAt(outside.zw))
    discard;
  fragment = vec4(0.0, 0.0, 0.0, clamp(away + 0.5, 0.0, 1.0));
}
