// SPDX-License-Identifier: Apache-2.0
// A headlight at the eye, so that light and view direction are one (S §3.5). Shadows deepen the
// colour instead of greying it, as an illustrator's glaze does. `facing` is ⟨n, v̂⟩.
vec3 phong(vec3 colour, float facing) {
  vec3 shadow = colour * colour * 0.42 + colour * 0.08;
  float light = facing * (1.3 - 0.3 * facing);
  float highlight = 0.16 * pow(facing, 36.0);
  return mix(shadow, colour * 1.02, light) + highlight;
}
