// SPDX-License-Identifier: Apache-2.0
// Blends the layers of a pixel front to back: it repeatedly takes the next-nearest depth among the
// layers of its tile, ties by their order in the list (METHOD §10).
flat in ivec2 list;

uniform sampler2D colours;       // premultiplied fills
uniform sampler2D inks;          // coverage
uniform sampler2D depths;        // 1 where a layer has nothing
uniform highp isampler2D entries;
uniform int rowBits;              // a row holds 1 << rowBits entries, as integer divisions are slow
uniform vec4 background;         // premultiplied

out vec4 fragment;

const int filled = 1 << 24;
const int inked = 1 << 25;

ivec4 entryAt(int index) {
  return texelFetch(entries, ivec2(index & ((1 << rowBits) - 1), index >> rowBits), 0);
}

vec4 layerColour(ivec4 entry, ivec2 texel) {
  vec4 colour = (entry.w & filled) != 0 ? texelFetch(colours, texel, 0) : vec4(0.0);
  if ((entry.w & inked) != 0) {
    float coverage = texelFetch(inks, texel, 0).r;
    vec3 ink = vec3((entry.w >> 16) & 255, (entry.w >> 8) & 255, entry.w & 255) / 255.0;
    colour = vec4(ink * coverage, coverage) + colour * (1.0 - coverage);
  }
  return colour;
}

void add(inout vec4 sum, int index, ivec2 pixel) {
  ivec4 entry = entryAt(list.x + index);
  ivec2 offset = ivec2(entry.x & 0xffff, (entry.x >> 16) & 0xffff) - 32768;
  sum += layerColour(entry, pixel + offset) * (1.0 - sum.a);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  // Each sweep finds the two nearest layers behind the last one.
  float lastDepth = -1.0;
  int lastIndex = -1;
  for (int layer = 0; layer < list.y; layer += 2) {
    vec2 nearest = vec2(1.0);
    ivec2 index = ivec2(-1);
    for (int i = 0; i < list.y; ++i) {
      ivec4 entry = entryAt(list.x + i);
      ivec2 low = ivec2(entry.y & 0xffff, entry.z & 0xffff);
      ivec2 high = ivec2((entry.y >> 16) & 0xffff, (entry.z >> 16) & 0xffff);
      if (any(lessThan(pixel, low)) || any(greaterThan(pixel, high)))
        continue;
      ivec2 offset = ivec2(entry.x & 0xffff, (entry.x >> 16) & 0xffff) - 32768;
      float depth = texelFetch(depths, pixel + offset, 0).r;
      bool behind = depth > lastDepth || (depth == lastDepth && i > lastIndex);
      if (behind && depth < nearest.x) {
        nearest = vec2(depth, nearest.x);
        index = ivec2(i, index.x);
      } else if (behind && depth < nearest.y) {
        nearest.y = depth;
        index.y = i;
      }
    }
    if (index.x < 0)
      break;
    add(sum, index.x, pixel);
    if (index.y < 0 || sum.a > 0.998)
      break;
    add(sum, index.y, pixel);
    if (sum.a > 0.998)
      break;
    lastDepth = nearest.y;
    lastIndex = index.y;
  }
  fragment = sum + background * (1.0 - sum.a);
}
