// SPDX-License-Identifier: Apache-2.0
// Runs S's line search (algorithm 1, eq. 5) along k in the picture, both ways from every pixel.
#include "depth.glsl"
uniform highp isampler2D fields;
uniform sampler2D depths;  // 1 where there is no surface
uniform ivec2 origin;      // of the layer in the target, which has the pixels of `fields`
uniform ivec2 extent;      // the layer's width and height
uniform vec4 projection;   // see depth.glsl
uniform int longest;       // steps
uniform float stride;      // px
uniform float contourJump; // mm in depth between two steps that mark a contour

out vec4 fragment;

const float permeabilityWeight = 0.05;  // τ_w

float depthAt(ivec2 texel) {
  bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, extent));
  return outside ? 1.0 : texelFetch(depths, texel, 0).r;
}

vec2 direction(ivec2 texel) {
  int bits = texelFetch(fields, texel, 0).x;
  return vec2((bits << 16) >> 16, bits >> 16) / 32767.0;
}

vec2 colourAndPermeability(int bits) {
  return vec2(bits & 0xffff, bits >> 16) / 32767.0;
}

// Returns R_d and the number of steps.
vec2 search(vec2 x, float sense, int own) {
  float dampening = 1.0;
  float last = eyeDistance(depthAt(ivec2(floor(x))), projection);
  for (int i = 1; i <= longest; ++i) {
    x += sense * stride * direction(ivec2(floor(x)));
    ivec2 texel = ivec2(floor(x));
    float depth = depthAt(texel);
    float distance = eyeDistance(depth, projection);
    if (depth >= 1.0 || abs(distance - last) > contourJump)
      return vec2(1.0, float(i));
    last = distance;
    ivec4 field = texelFetch(fields, texel, 0);
    vec2 seed = colourAndPermeability(field.y);
    dampening *= 1.0 - permeabilityWeight * (1.0 - seed.y);
    if (seed.x < 0.999 && field.w != own)
      return vec2(dampening * seed.x + 1.0 - dampening, float(i));
  }
  return vec2(1.0, float(longest));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy) - origin;
  float depth = depthAt(texel);
  if (depth >= 1.0)
    discard;
  ivec4 field = texelFetch(fields, texel, 0);
  float opacity = intBitsToFloat(field.z);
  if (opacity <= 0.002)
    discard;
  vec2 x = vec2(texel) + 0.5;
  vec2 ahead = search(x, 1.0, field.w);
  vec2 back = search(x, -1.0, field.w);
  float colour = (back.x * ahead.y + ahead.x * back.y) / (ahead.y + back.y);
  float coverage = (1.0 - colour) * opacity;
  if (coverage <= 0.002)
    discard;
  fragment = vec4(coverage);
  gl_FragDepth = depth;
}
