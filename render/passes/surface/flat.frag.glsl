// SPDX-License-Identifier: Apache-2.0
#ifdef SECTIONED
#include "sections.glsl"
in vec3 place;
#endif
uniform vec4 colour;

out vec4 fragment;

void main() {
#ifdef SECTIONED
  if (cutAway(place))
    discard;
#endif
  fragment = colour;
}
