// SPDX-License-Identifier: Apache-2.0
// Finds which places of a stroke its own surface leaves in sight, for one stroke per pixel: places
// lie a pixel apart and serve the whole width of the stroke. Software rasterisers look depths up
// as often as this, not again for every pixel that a stroke may cover.
#include "depth.glsl"
#include "sight.glsl"
#include "surface_depth.glsl"
uniform sampler2D strokes;  // three texels each: a and b; outwards; depths, tolerance in mm, look
uniform sampler2D looks;    // three texels each: slot; toAtlas, reach; probe, sheet, contours or not
uniform vec4 projection;    // see depth.glsl

// Bit i tells whether place i is in sight, bit 16 + i whether a contour's surface goes on there
// outside the pen.
out int sight;

// `reach` holds the px at which a contour's far side is looked for: a small and a wide step.
struct Look {
  Slot slot;
  vec2 reach;
  float probe;  // distance outside (px) at which the own mask means an inner contour
  float sheet;  // mm by which a surface may hide a line of its own sheet
  bool contours;
};

Look lookOf(int index) {
  ivec2 first = ivec2(3 * (index & 255), index >> 8);
  vec4 pixels = texelFetch(looks, first, 0);
  vec4 way = texelFetch(looks, first + ivec2(1, 0), 0);
  vec4 rest = texelFetch(looks, first + ivec2(2, 0), 0);
  return Look(Slot(ivec4(pixels), ivec2(way.xy)), way.zw, rest.x, rest.y, rest.z > 0.0);
}

// A line on the surface is in sight if one of the four texels around it is no nearer.
vec2 lookAround(int k) {
  return (vec2(k & 1, k >> 1) - 0.5) * surfaceStep;
}

const int probing = 4;

// All looks at all places go through one loop, as software rasterisers go through every branch but
// leave loops where no pixel needs them any more.
void main() {
  ivec2 first = ivec2(3, 1) * ivec2(gl_FragCoord.xy);
  vec4 ends = texelFetch(strokes, first, 0);
  vec4 outwards = texelFetch(strokes, first + ivec2(1, 0), 0);
  vec4 depths = texelFetch(strokes, first + ivec2(2, 0), 0);
  int word = int(depths.w);
  int steps = word & 15;
  Look look = lookOf(word >> 4);
  float middle = 0.5 * (depths.x + depths.y);
  float tolerance = depthLift(middle, depths.z, projection);
  float sheet = depthLift(middle, look.sheet, projection);
  sight = 0;
  float here = 0.0;  // depth of the surface at the place itself
  int seen = 0;      // by which look
  int k = 0;
  for (int i = 0; i <= steps;) {
    float t = float(i) / float(max(steps, 1));
    float depth = mix(depths.x, depths.y, t);
    vec2 outward = normalize(mix(outwards.xy, outwards.zw, t) + vec2(1e-6, 0.0));
    float outside = k == probing ? probeOutside(seen, look.probe, look.reach)
                                 : lookOutside(k, look.reach);
    vec2 to = look.contours ? outside * outward : lookAround(k);
    float surface = surfaceDepthAt(mix(ends.xy, ends.zw, t) + to, look.slot);
    bool done = true;
    if (k == probing) {
      if (surface < 1.0)
        sight |= 0x10000 << i;
    } else {
      here = k == 0 ? surface : here;
      int after = afterLook(k, surface, depth, here, vec2(tolerance, look.contours ? sheet : depth));
      if (after == lineSeen) {
        sight |= 1 << i;
        seen = k;
      }
      done = after == lookedEnough || (after == lineSeen && !look.contours);
      k = after == lineSeen ? probing : after;
    }
    if (done) {
      k = 0;
      ++i;
    }
  }
}
