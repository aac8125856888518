// SPDX-License-Identifier: Apache-2.0
// Draws one rectangle, the whole of the viewport.
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0, 0.0, 1.0);
}
