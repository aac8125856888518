// SPDX-License-Identifier: Apache-2.0
// Computes what the convolution reads: the direction of the stronger curvature in the picture, noise
// that stays with the surface, and the shade.
in vec3 noisePosition;
in vec3 clipPosition;
in vec3 surfaceNormal;
in vec3 towardsEye;
in vec4 scaledShapeA;
in vec2 scaledShapeB;

uniform sampler2D surfaceDepth;
uniform ivec2 toAtlas;  // from this target's pixels to the atlas'
uniform mat4 viewProjection;
uniform vec2 pictureSize;
uniform vec3 light;  // unit, towards the light
uniform vec3 shading;  // the least shade that is drawn, the share of light from the eye, and T
uniform int twoSided;

out ivec4 field;  // direction; bits of the noise; bits of the shade; 1 where there is a direction

uint scrambled(uint x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

float noiseAt(vec3 p) {
  ivec3 cell = ivec3(floor(p));
  uint bits = scrambled(uint(cell.x) + scrambled(uint(cell.y) + scrambled(uint(cell.z))));
  return float(bits & 0xffffu) / 65535.0;
}

vec3 shapeTimes(vec3 v) {
  return vec3(scaledShapeA.x * v.x + scaledShapeA.w * v.y + scaledShapeB.x * v.z,
              scaledShapeA.w * v.x + scaledShapeA.y * v.y + scaledShapeB.y * v.z,
              scaledShapeB.x * v.x + scaledShapeB.y * v.y + scaledShapeA.z * v.z);
}

// Returns the unit direction of the curvature of larger magnitude, of either sign.
vec3 strongerDirection(vec3 n) {
  vec3 a = normalize(abs(n.z) < 0.9 ? cross(n, vec3(0.0, 0.0, 1.0)) : cross(n, vec3(1.0, 0.0, 0.0)));
  vec3 b = cross(n, a);
  vec3 sa = shapeTimes(a);
  vec3 sb = shapeTimes(b);
  vec2 across = vec2(dot(sa, a) - dot(sb, b), 2.0 * dot(sa, b));
  if (dot(sa, a) + dot(sb, b) < 0.0)
    across = -across;
  float angle = 0.5 * atan(across.y, across.x);
  return length(across) > 1e-6 ? cos(angle) * a + sin(angle) * b : vec3(0.0);
}

void main() {
  // This pass leaves out the pixels that the surface pass left out.
  float depth = texelFetch(surfaceDepth, ivec2(gl_FragCoord.xy) + toAtlas, 0).r;
  if (abs(gl_FragCoord.z - depth) > 4e-6)
    discard;
  vec3 n = normalize(surfaceNormal);
  vec3 v = normalize(towardsEye);
  if (twoSided != 0 && dot(n, v) < 0.0)
    n = -n;
  vec3 along = strongerDirection(n);
  vec4 moved = viewProjection * vec4(along, 0.0);
  vec2 direction = (moved.xy * clipPosition.z - clipPosition.xy * moved.w) * pictureSize;
  float pixels = length(direction);
  direction = pixels > 1e-20 ? direction / pixels : vec2(0.0);
  float lit = (1.0 - shading.y) * max(dot(n, light), 0.0) + shading.y * max(dot(n, v), 0.0);
  float shade = clamp((1.0 - lit - shading.x) / (1.0 - shading.x), 0.0, 1.0) * shading.z;
  ivec2 d = ivec2(round(direction * 32767.0));
  field = ivec4((d.x & 0xffff) | d.y << 16, floatBitsToInt(noiseAt(noisePosition)),
                floatBitsToInt(shade), pixels > 1e-20 ? 1 : 0);
}
