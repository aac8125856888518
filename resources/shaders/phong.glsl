// SPDX-License-Identifier: Apache-2.0
// Shadows deepen the colour instead of greying it, as an illustrator's glaze does. Pure colours, of
// which the strong channel hardly falls that way, would look flat and so become darker as a whole.
vec3 inShadow(vec3 colour) {
  float chroma = max(max(colour.r, colour.g), colour.b) - min(min(colour.r, colour.g), colour.b);
  return (colour * colour * 0.42 + colour * 0.08) * (1.0 - 0.4 * chroma * chroma);
}

// Shades with a headlight at the eye, so that light and view direction are one (S §3.5). `facing`
// is ⟨n, v̂⟩.
vec3 phong(vec3 colour, float facing) {
  float light = facing * (1.3 - 0.3 * facing);
  float highlight = 0.16 * pow(facing, 36.0);
  return mix(inShadow(colour), colour * 1.02, light) + highlight;
}

// Shades with a key light as well: `lit` is ⟨n, l⟩, `glint` ⟨n, h⟩ with h halfway between light and
// view direction. The key light reaches a little around the form, and the headlight keeps what lies
// in its shadow readable.
vec3 phongWithKey(vec3 colour, float facing, float lit, float glint) {
  float key = max((lit + 0.3) / 1.3, 0.0);
  float head = facing * (1.3 - 0.3 * facing);
  float light = 0.22 * head + sqrt(head) * key;
  float highlight = 0.16 * pow(max(glint, 0.0), 36.0);
  return mix(inShadow(colour), colour * 1.02, min(light, 1.0)) + highlight;
}
