// SPDX-License-Identifier: Apache-2.0
// Lays pixels over those of the target.
uniform sampler2D colours;  // premultiplied
uniform ivec2 corner;       // of theirs in the target

out vec4 fragment;

void main() {
  fragment = texelFetch(colours, ivec2(gl_FragCoord.xy) - corner, 0);
}
