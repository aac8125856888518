// SPDX-License-Identifier: Apache-2.0
// Draws one square tile per instance.
layout(location = 0) in ivec4 tile;  // first pixel x and y, first entry of its list, entries

uniform vec2 targetSize;
uniform float tileSide;

flat out ivec2 list;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 pixel = vec2(tile.xy) + tileSide * corner;
  gl_Position = vec4(pixel / targetSize * 2.0 - 1.0, 0.0, 1.0);
  list = tile.zw;
}
