// SPDX-License-Identifier: Apache-2.0
// Draws surfaces enlarged.
#include "enlarged.glsl"

out vec4 fragment;

void main() {
  Enlarged here = enlargedAt(gl_FragCoord.xy);
  fragment = here.colour;
  gl_FragDepth = here.depth;
}
