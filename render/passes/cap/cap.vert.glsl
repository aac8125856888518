// SPDX-License-Identifier: Apache-2.0
#include "place.glsl"
layout(location = 0) in vec3 position;

uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec4 layer;

out vec3 place;

void main() {
  gl_Position = layerClip(viewProjection * vec4(position, 1.0), pictureSize, layer);
  place = position;
}
