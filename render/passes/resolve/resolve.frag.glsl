// SPDX-License-Identifier: Apache-2.0
// Blends the layers of a pixel front to back: a sweep over the layers of its tile finds the four
// nearest, ties by their order in the list, and further sweeps those behind (METHOD §10).
#include "layers.glsl"
flat in ivec2 list;
// Offsets from the picture to the atlas of the list's first layers: each is looked up in a texture
// as well, but software drivers take as long for that as for all else that a sweep does with it.
flat in ivec4 offsets0;
flat in ivec4 offsets1;
flat in ivec4 offsets2;

uniform sampler2D colours;       // premultiplied fills
uniform sampler2D inks;          // coverage; y: up to 0.5 that of hidden lines, above it a halo
uniform sampler2D depths;        // 1 where a layer has nothing
uniform highp isampler2D offsets;  // of the lists' layers, from the picture to the atlas
uniform highp isampler2D looks;
uniform int rowBits;               // a row holds 1 << rowBits layers, as integer divisions are slow
uniform vec4 background;           // premultiplied
uniform int hiddenLines;           // 1: some layer has hidden lines

out vec4 fragment;

const int filled = 1 << 24;
const int inked = 1 << 25;
const int hiddenInk = 1 << 26;
const int haloed = 1 << 27;

ivec2 placeOf(int index) {
  return ivec2(index & ((1 << rowBits) - 1), index >> rowBits);
}

int offsetOf(int index) {
  return texelFetch(offsets, placeOf(index), 0).r;
}

ivec2 texelOf(int offset, ivec2 pixel) {
  return pixel + ivec2(offset & 0xffff, (offset >> 16) & 0xffff) - 32768;
}

vec3 inkOf(int look) {
  return vec3((look >> 16) & 255, (look >> 8) & 255, look & 255) / 255.0;
}

vec4 inkedWith(vec4 ink, float coverage, vec4 colour) {
  return vec4(layered(ink.r, coverage, colour.r), layered(ink.g, coverage, colour.g),
              layered(ink.b, coverage, colour.b), layered(ink.a, coverage, colour.a));
}

vec4 behind(vec4 sum, vec4 colour) {
  return vec4(laidBehind(sum.r, sum.a, colour.r), laidBehind(sum.g, sum.a, colour.g),
              laidBehind(sum.b, sum.a, colour.b), laidBehind(sum.a, sum.a, colour.a));
}

// `lines` is the share of lines that is left behind the halos of nearer layers.
vec4 layerColour(int look, ivec2 texel, inout float lines) {
  vec4 colour = (look & filled) != 0 ? texelFetch(colours, texel, 0) : vec4(0.0);
  if ((look & inked) != 0) {
    vec2 coverage = texelFetch(inks, texel, 0).rg;
    coverage.r *= lines;
    colour = inkedWith(vec4(inkOf(look), 1.0), coverage.r, colour);
    if ((look & haloed) != 0 && coverage.g > haloAbove)
      lines = 0.0;
  }
  return colour;
}

// Lays the hidden lines of all layers over the picture. A line that is seen has the same ink and
// covers its own.
vec4 withHiddenLines(vec4 colour, ivec2 pixel) {
  for (int i = 0; i < list.y; ++i) {
    int look = texelFetch(looks, placeOf(list.x + i), 0).r;
    if ((look & hiddenInk) == 0)
      continue;
    float stored = texelFetch(inks, texelOf(offsetOf(list.x + i), pixel), 0).g;
    colour = inkedWith(vec4(inkOf(look), 1.0), hiddenCoverage(stored), colour);
  }
  return colour;
}

#ifndef ONE_LAYER
// Holds the four nearest layers of a sweep, the nearest first: their places in the list (−1: none)
// and offsets.
struct Nearest {
  vec4 depth;
  vec4 index;
  ivec4 offset;
};

// Puts a layer in its place among the nearest, if it lies behind the last one of the sweep before.
void place(inout Nearest found, int offset, int i, ivec2 pixel, vec2 last) {
  float depth = texelFetch(depths, texelOf(offset, pixel), 0).r;
  float index = float(i);
  if (!liesBefore(last.x, last.y, depth, index))
    depth = 1.0;
  // Whatever is farther moves on by one.
  bvec4 before = lessThan(vec4(depth), found.depth);
  bvec4 moving = bvec4(false, before.xyz);
  vec4 movedDepth = mix(vec4(depth), found.depth.xxyz, moving);
  vec4 movedIndex = mix(vec4(index), found.index.xxyz, moving);
  found.offset.w = before.w ? (moving.w ? found.offset.z : offset) : found.offset.w;
  found.offset.z = before.z ? (moving.z ? found.offset.y : offset) : found.offset.z;
  found.offset.y = before.y ? (moving.y ? found.offset.x : offset) : found.offset.y;
  found.offset.x = before.x ? offset : found.offset.x;
  found.depth = mix(found.depth, movedDepth, before);
  found.index = mix(found.index, movedIndex, before);
}

Nearest sweep(ivec2 pixel, vec2 last) {
  Nearest found = Nearest(vec4(1.0), vec4(-1.0), ivec4(0));
  ivec4 a = offsets0;
  ivec4 b = offsets1;
  ivec4 c = offsets2;
  for (int i = 0; i < min(list.y, 12); ++i) {
    place(found, a.x, i, pixel, last);
    a = ivec4(a.yzw, b.x);
    b = ivec4(b.yzw, c.x);
    c = ivec4(c.yzw, 0);
  }
  for (int i = 12; i < list.y; ++i)
    place(found, offsetOf(list.x + i), i, pixel, last);
  return found;
}
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = vec4(0.0);
  float lines = 1.0;
#ifdef ONE_LAYER
  ivec2 texel = texelOf(offsets0.x, pixel);
  if (texelFetch(depths, texel, 0).r < 1.0)
    sum = layerColour(texelFetch(looks, placeOf(list.x), 0).r, texel, lines);
#else
  vec2 last = vec2(-1.0);
  for (int seen = 0; seen < list.y; seen += 4) {
    Nearest found = sweep(pixel, last);
    last = vec2(found.depth.w, found.index.w);
    while (found.index.x >= 0.0 && sum.a <= hidesAll) {
      int look = texelFetch(looks, placeOf(list.x + int(found.index.x)), 0).r;
      sum = behind(sum, layerColour(look, texelOf(found.offset.x, pixel), lines));
      found.index = vec4(found.index.yzw, -1.0);
      found.offset = found.offset.yzww;
    }
    if (last.y < 0.0 || sum.a > hidesAll)
      break;
  }
#endif
  fragment = behind(sum, background);
  if (hiddenLines != 0)
    fragment = withHiddenLines(fragment, pixel);
}
