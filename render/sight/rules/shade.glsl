// SPDX-License-Identifier: Apache-2.0
// How light falls on a fill and how much of its shading has entered (S §3.5, METHOD §7). See rules.h
// for what may be written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif

CONSTANT float quarterTurn = 1.5707963268f;

// Shadows deepen the colour instead of greying it, as an illustrator's glaze does. Pure colours, of
// which the strong channel hardly falls that way, would look flat and so become darker as a whole.
RULE vec3 inShadow(vec3 colour) {
  float chroma = max(max(colour.r, colour.g), colour.b) - min(min(colour.r, colour.g), colour.b);
  return (colour * colour * 0.42f + colour * 0.08f) * (1.0f - 0.4f * chroma * chroma);
}

// Returns how much a lamp at the eye lights a place, so that light and view direction are one.
// `facing` is ⟨n, v̂⟩.
RULE float headlight(float facing) {
  return facing * (1.3f - 0.3f * facing);
}

// Returns how much light there is with a key light as well: `lit` is ⟨n, l⟩. It reaches a little
// around the form, and the headlight keeps what lies in its shadow readable.
RULE float keyLight(float facing, float lit) {
  float head = headlight(facing);
  return min(0.22f * head + sqrt(head) * max((lit + 0.3f) / 1.3f, 0.0f), 1.0f);
}

// Returns 0.16·x³⁶, the highlight: x is ⟨n, v̂⟩ or, with a key light, ⟨n, h⟩ with h halfway between
// light and view direction, at least 0.
RULE float highlight(float x) {
  float x2 = x * x;
  float x4 = x2 * x2;
  float x8 = x4 * x4;
  float x16 = x8 * x8;
  return 0.16f * (x16 * x16 * x4);
}

// Returns a channel of the colour in that light.
RULE float shaded(float shadow, float colour, float light, float glint) {
  return mix(shadow, 1.02f * colour, light) + glint;
}

// Returns the arc cosine of 0 … 1, within 7·10⁻⁵ (Abramowitz and Stegun 1964, 4.4.45).
RULE float arcCosine(float x) {
  return sqrt(1.0f - x) *
         (1.5707288f + x * (-0.2121144f + x * (0.0742610f - 0.0187293f * x)));
}

// Returns the angle by which shading enters. Paper is light by itself and shading enters from the
// dark rim; on a dark ground, where `onDark` is 1 and else 0, light enters, from the parts that face
// the eye.
RULE float enteringAngle(float facing, float onDark) {
  float angle = arcCosine(facing);
  return angle + onDark * (quarterTurn - 2.0f * angle);
}

// Returns the share of shading that has entered: S eq. 11 with the last term's sign as METHOD §7
// reads it. `bent` is ⟨k, v̂⟩·F_c on the side that is seen, `shading` is T_P and `complete`
// clamp01(Γ − 4).
RULE float enteredAt(float angle, float bent, float shading, float complete) {
  float threshold = quarterTurn * (1.0f - shading);
  float byAngle =
      clamp((angle - threshold) / max(quarterTurn - threshold, 1e-4f), 0.0f, 1.0f);
  float byLight = clamp(bent, 0.0f, 1.0f) * (1.0f - shading) + shading;
  return mix(byAngle * byLight, 1.0f, complete);
}

// Returns a channel of a fill. A thin glaze shows at least `least`, its own colour: its shadows,
// which would grey the paper, deepen as it closes.
RULE float glazed(float shade, float least, float entered) {
  return min(mix(max(shade, least), shade, entered), 1.0f);
}

// Returns where in the table of stages (FillStages) a Γ is found.
RULE float stagePlace(float gamma) {
  return gamma < 4.0f ? 16.0f * sqrt(max(gamma - 3.0f, 0.0f)) : 16.0f + 16.0f * (gamma - 4.0f);
}
