// SPDX-License-Identifier: Apache-2.0
// Passes on the position alone, for depth and for fills of one colour.
#include "place.glsl"
layout(location = 0) in vec3 position;

uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec4 layer;

#ifdef SECTIONED
out vec3 place;
#endif

void main() {
  gl_Position = layerClip(viewProjection * vec4(position, 1.0), pictureSize, layer);
#ifdef SECTIONED
  place = position;
#endif
}
