// SPDX-License-Identifier: Apache-2.0
// Draws a line around marked structures over the picture: where the numbers of marked structures
// change from pixel to pixel. It is strong where the structure is seen and weak where other layers
// hide it. How far the border is follows from the share of like pixels around, weighted by a
// Gaussian, so that the line is smooth although each pixel has but one number.
flat in ivec2 list;

uniform sampler2D numbers;       // red: number of the marked structure, 0 for none
uniform sampler2D numberDepths;  // how deep it lies there
uniform sampler2D colours;       // as in resolve.frag.glsl
uniform sampler2D depths;
uniform highp isampler2D offsets;
uniform highp isampler2D looks;  // with a number in place of the ink: whom it does not hide
uniform int rowBits;
uniform ivec2 corner;  // of the region in the target
uniform vec3 ink;
uniform vec3 casing;    // beside the ink, to set it off from what is there
uniform vec4 pen;       // half width of the ink, that of the casing, strength, strength where hidden
uniform float scale;    // standard deviation of the Gaussian, px
uniform int reach;      // px that are looked at each way

out vec4 fragment;

const int filled = 1 << 24;
const float depthStep = 2e-4;  // among structures that share a layer, less is the structure itself

float numberAt(ivec2 pixel) {
  ivec2 inside = clamp(pixel, ivec2(0), textureSize(numbers, 0) - 1);
  return texelFetch(numbers, inside, 0).r;
}

bool nearBorder(ivec2 pixel, float own) {
  for (int i = 0; i < 9; ++i) {
    ivec2 way = ivec2(i % 3 - 1, i / 3 - 1);
    if (numberAt(pixel + way) != own || numberAt(pixel + reach * way) != own)
      return true;
  }
  return false;
}

// Returns the share of light that reaches the eye from the marked structure at the pixel.
float seenAt(ivec2 pixel) {
  int own = int(numberAt(pixel) * 255.0 + 0.5);
  float depth = texelFetch(numberDepths, pixel, 0).r;
  float seen = 1.0;
  for (int i = 0; i < list.y; ++i) {
    int index = list.x + i;
    ivec2 place = ivec2(index & ((1 << rowBits) - 1), index >> rowBits);
    int look = texelFetch(looks, place, 0).r;
    if ((look & filled) == 0 || (look & 255) == own)
      continue;
    int offset = texelFetch(offsets, place, 0).r;
    ivec2 texel = pixel + ivec2(offset & 0xffff, (offset >> 16) & 0xffff) - 32768;
    if (texelFetch(depths, texel, 0).r < depth - depthStep)
      seen *= 1.0 - texelFetch(colours, texel, 0).a;
  }
  return seen;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) - corner;
  float own = numberAt(pixel);
  if (!nearBorder(pixel, own))
    discard;
  float like = 0.0;
  float all = 0.0;
  int nearest = 1 << 20;
  ivec2 marked = pixel;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      int away = x * x + y * y;
      float weight = exp(-0.5 * float(away) / (scale * scale));
      float number = numberAt(pixel + ivec2(x, y));
      all += weight;
      like += number == own ? weight : 0.0;
      if (number > 0.0 && away < nearest) {
        nearest = away;
        marked = clamp(pixel + ivec2(x, y), ivec2(0), textureSize(numbers, 0) - 1);
      }
    }
  if (nearest == 1 << 20)
    discard;
  // The share is 1/2 at the border and changes there by the Gaussian's height per pixel.
  float away = (like / all - 0.5) * scale * 2.5066;
  // What is thinner than the line has no inside.
  away = own > 0.0 ? max(away, 0.0) : abs(away);
  float line = clamp(pen.x + 0.5 - away, 0.0, 1.0);
  float around = clamp(pen.y + 0.5 - away, 0.0, 1.0);
  float seen = seenAt(marked);
  float strength = mix(pen.w, pen.z, smoothstep(0.2, 0.4, seen));
  vec4 colour = vec4(mix(casing, ink, line), 1.0) * max(line, 0.7 * around);
  fragment = colour * strength;
}
