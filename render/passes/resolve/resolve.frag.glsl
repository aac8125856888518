// SPDX-License-Identifier: Apache-2.0
// Blends the layers of a pixel front to back: it repeatedly takes the next-nearest depth among the
// layers of its tile, ties by their order in the list (METHOD §10).
flat in ivec2 list;

uniform sampler2D colours;       // premultiplied fills
uniform sampler2D inks;          // coverage; y: up to 0.5 that of hidden lines, above it a halo
uniform sampler2D depths;        // 1 where a layer has nothing
uniform highp isampler2D entries;
uniform int rowBits;              // a row holds 1 << rowBits entries, as integer divisions are slow
uniform vec4 background;         // premultiplied
uniform int hiddenLines;         // 1: some layer has hidden lines

out vec4 fragment;

const int filled = 1 << 24;
const int inked = 1 << 25;
const int hiddenInk = 1 << 26;
const int haloed = 1 << 27;
const float hiddenStrength = 0.5;

ivec4 entryAt(int index) {
  return texelFetch(entries, ivec2(index & ((1 << rowBits) - 1), index >> rowBits), 0);
}

vec3 inkOf(ivec4 entry) {
  return vec3((entry.w >> 16) & 255, (entry.w >> 8) & 255, entry.w & 255) / 255.0;
}

// `lines` is the share of lines that is left behind the halos of nearer layers.
vec4 layerColour(ivec4 entry, ivec2 texel, inout float lines) {
  vec4 colour = (entry.w & filled) != 0 ? texelFetch(colours, texel, 0) : vec4(0.0);
  if ((entry.w & inked) != 0) {
    vec2 coverage = texelFetch(inks, texel, 0).rg;
    coverage.r *= lines;
    colour = vec4(inkOf(entry) * coverage.r, coverage.r) + colour * (1.0 - coverage.r);
    if ((entry.w & haloed) != 0 && coverage.g > 0.75)
      lines = 0.0;
  }
  return colour;
}

void add(inout vec4 sum, int index, ivec2 pixel, inout float lines) {
  ivec4 entry = entryAt(list.x + index);
  ivec2 offset = ivec2(entry.x & 0xffff, (entry.x >> 16) & 0xffff) - 32768;
  sum += layerColour(entry, pixel + offset, lines) * (1.0 - sum.a);
}

// Lays the hidden lines of all layers over the picture. A line that is seen has the same ink and
// covers its own.
vec4 withHiddenLines(vec4 colour, ivec2 pixel) {
  for (int i = 0; i < list.y; ++i) {
    ivec4 entry = entryAt(list.x + i);
    if ((entry.w & hiddenInk) == 0)
      continue;
    ivec2 low = ivec2(entry.y & 0xffff, entry.z & 0xffff);
    ivec2 high = ivec2((entry.y >> 16) & 0xffff, (entry.z >> 16) & 0xffff);
    if (any(lessThan(pixel, low)) || any(greaterThan(pixel, high)))
      continue;
    ivec2 offset = ivec2(entry.x & 0xffff, (entry.x >> 16) & 0xffff) - 32768;
    float stored = texelFetch(inks, pixel + offset, 0).g;
    float coverage = stored > 0.75 ? 0.0 : min(2.0 * stored, 1.0) * hiddenStrength;
    colour = vec4(inkOf(entry) * coverage, coverage) + colour * (1.0 - coverage);
  }
  return colour;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  float lines = 1.0;
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
    add(sum, index.x, pixel, lines);
    if (index.y < 0 || sum.a > 0.998)
      break;
    add(sum, index.y, pixel, lines);
    if (sum.a > 0.998)
      break;
    lastDepth = nearest.y;
    lastIndex = index.y;
  }
  fragment = sum + background * (1.0 - sum.a);
  if (hiddenLines != 0)
    fragment = withHiddenLines(fragment, pixel);
}
