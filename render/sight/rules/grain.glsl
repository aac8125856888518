// SPDX-License-Identifier: Apache-2.0
// How a rough paper takes ink: its hollows stay without, as under a pencil. Noise between the points
// of a grid, at two scales. See rules.h for what may be written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif

RULE float grainAt(vec2 point) {
  vec3 p = fract(vec3(point.x, point.y, point.x) * vec3(0.1031f, 0.1030f, 0.0973f));
  p += dot(p, vec3(p.y, p.z, p.x) + 33.33f);
  return fract((p.x + p.y) * p.z);
}

RULE float grainBetween(vec2 place) {
  vec2 cell = floor(place);
  vec2 t = place - cell;
  t = t * t * (3.0f - 2.0f * t);
  return mix(mix(grainAt(cell), grainAt(cell + vec2(1.0f, 0.0f)), t.x),
             mix(grainAt(cell + vec2(0.0f, 1.0f)), grainAt(cell + vec2(1.0f, 1.0f)), t.x), t.y);
}

// Returns the share of ink that the paper takes at a place of it, in pixels of the whole picture.
// `grain` holds how much of the paper shows, 0 … 1, and the size of its grain in pixels.
RULE float inkTaken(vec2 pixel, vec2 grain) {
  float height =
      0.65f * grainBetween(pixel / grain.y) + 0.35f * grainBetween(0.37f * pixel / grain.y + 17.0f);
  return mix(1.0f, 0.25f + 0.85f * smoothstep(0.25f, 0.6f, height), grain.x);
}
