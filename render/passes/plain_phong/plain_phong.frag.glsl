// SPDX-License-Identifier: Apache-2.0
#include "shaded_colour.glsl"
in vec3 surfaceNormal;
in vec3 toEye;

uniform vec3 colour;

out vec4 fragment;

void main() {
  float nv = min(abs(dot(normalize(surfaceNormal), normalize(toEye))), 1.0);
  fragment = vec4(min(shadedColour(colour, headlight(nv), highlight(nv)), 1.0), 1.0);
}
