// SPDX-License-Identifier: Apache-2.0
// Draws one rectangle per instance.
layout(location = 0) in ivec4 tile;  // first pixel (16 bits each), width and height, first layer, layers
layout(location = 1) in ivec4 first0;  // offsets of the first layers
layout(location = 2) in ivec4 first1;
layout(location = 3) in ivec4 first2;

uniform vec2 targetSize;

flat out ivec2 list;
flat out ivec4 offsets0;
flat out ivec4 offsets1;
flat out ivec4 offsets2;

void main() {
  ivec2 first = ivec2(tile.x & 0xffff, (tile.x >> 16) & 0xffff);
  ivec2 size = ivec2(tile.y & 0xffff, (tile.y >> 16) & 0xffff);
  vec2 pixel = vec2(first + ivec2(gl_VertexID & 1, gl_VertexID >> 1) * size);
  gl_Position = vec4(pixel / targetSize * 2.0 - 1.0, 0.0, 1.0);
  list = tile.zw;
  offsets0 = first0;
  offsets1 = first1;
  offsets2 = first2;
}
