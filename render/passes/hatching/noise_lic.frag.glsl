// SPDX-License-Identifier: Apache-2.0
// Draws noise out along the field, both ways from every pixel (Cabral & Leedom, "Imaging Vector
// Fields Using Line Integral Convolution", SIGGRAPH 1993), and inks what is darker than the light.
#include "depth.glsl"
uniform highp isampler2D fields;
uniform sampler2D depths;   // 1 where there is no surface
uniform ivec2 origin;       // of the layer in the target, which has the pixels of `fields`
uniform ivec2 extent;       // the layer's width and height
uniform vec4 projection;    // see depth.glsl
uniform int longest;        // steps
uniform float stride;       // px
uniform float contourJump;  // mm in depth between two steps that mark a contour

out vec4 fragment;

const float contrast = 2.2;  // of means of noise, so that they fill 0 … 1
const float edge = 0.27;     // half the range of noise over which ink becomes paper

float depthAt(ivec2 texel) {
  bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, extent));
  return outside ? 1.0 : texelFetch(depths, texel, 0).r;
}

vec2 directionOf(ivec4 field) {
  return vec2((field.x << 16) >> 16, field.x >> 16) / 32767.0;
}

// Returns the sum of noise and the number of steps; directions have no sign of their own.
vec2 convolution(vec2 x, vec2 way) {
  vec2 sum = vec2(0.0);
  float last = eyeDistance(depthAt(ivec2(floor(x))), projection);
  for (int i = 1; i <= longest; ++i) {
    x += stride * way;
    ivec2 texel = ivec2(floor(x));
    float depth = depthAt(texel);
    float distance = eyeDistance(depth, projection);
    if (depth >= 1.0 || abs(distance - last) > contourJump)
      break;
    last = distance;
    ivec4 field = texelFetch(fields, texel, 0);
    sum += vec2(intBitsToFloat(field.y), 1.0);
    vec2 next = directionOf(field);
    if (field.w == 0 || dot(next, next) < 0.25)
      break;
    way = dot(next, way) < 0.0 ? -next : next;
  }
  return sum;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) - origin;
  float depth = depthAt(texel);
  if (depth >= 1.0)
    discard;
  ivec4 field = texelFetch(fields, texel, 0);
  float shade = intBitsToFloat(field.z);
  if (shade <= 0.0)
    discard;
  vec2 x = vec2(texel) + 0.5;
  vec2 along = directionOf(field);
  vec2 sum = vec2(intBitsToFloat(field.y), 1.0);
  if (field.w != 0)
    sum += convolution(x, along) + convolution(x, -along);
  float noise = clamp(0.5 + contrast * (sum.x / sum.y - 0.5), 0.0, 1.0);
  // In the deepest shade some of the paper is left.
  float ink = 0.78 * shade;
  float coverage = 1.0 - smoothstep(ink - edge, ink + edge, noise + edge * (1.0 - shade));
  if (coverage <= 0.004)
    discard;
  fragment = vec4(coverage);
  gl_FragDepth = depth;
}
