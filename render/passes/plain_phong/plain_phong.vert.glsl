// SPDX-License-Identifier: Apache-2.0
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;

uniform mat4 viewProjection;
uniform vec4 eye;

out vec3 surfaceNormal;
out vec3 toEye;

void main() {
  gl_Position = viewProjection * vec4(position, 1.0);
  surfaceNormal = normal.xyz;
  toEye = eye.xyz - eye.w * position;
}
