// SPDX-License-Identifier: Apache-2.0
// Draws one rectangle per instance, infinitely far away.
layout(location = 0) in ivec4 rectangle;  // first pixel x and y, width and height

uniform vec2 targetSize;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 pixel = vec2(rectangle.xy) + corner * vec2(rectangle.zw);
  gl_Position = vec4(pixel / targetSize * 2.0 - 1.0, 1.0, 1.0);
}
