// SPDX-License-Identifier: Apache-2.0
// Leaves the hollows of a rough paper without ink, as a pencil does: noise between the points of a
// grid, at two scales, in place on the paper.
uniform vec2 grain;  // how much, above 0 … 1, and the size of the paper's grain, px

float grainAt(vec2 point) {
  vec3 p = fract(vec3(point.xyx) * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yzx + 33.33);
  return fract((p.x + p.y) * p.z);
}

float paper(vec2 pixel) {
  vec2 cell = floor(pixel);
  vec2 t = pixel - cell;
  t = t * t * (3.0 - 2.0 * t);
  return mix(mix(grainAt(cell), grainAt(cell + vec2(1.0, 0.0)), t.x),
             mix(grainAt(cell + vec2(0.0, 1.0)), grainAt(cell + vec2(1.0, 1.0)), t.x), t.y);
}

float grained(vec2 pixel) {
  float height = 0.65 * paper(pixel / grain.y) + 0.35 * paper(0.37 * pixel / grain.y + 17.0);
  return mix(1.0, 0.25 + 0.85 * smoothstep(0.25, 0.6, height), grain.x);
}
