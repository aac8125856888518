// SPDX-License-Identifier: Apache-2.0
// How much of a pixel a pen covers (METHOD §4, S eq. 1). See rules.h for what may be written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif
#ifndef NUMBER
#define NUMBER float
#endif

// Returns the share of a pixel that is covered by a pen whose middle is so many pixels away; it
// fades over `edge` pixels.
RULE NUMBER penCoverage(NUMBER halfWidth, NUMBER away, float edge) {
  return clamp((halfWidth - away) / edge + 0.5f, 0.0f, 1.0f);
}

// Pens never become thinner than one pixel and lose opacity instead: these return half the width in
// pixels with which a pen is drawn, and the opacity that is left to it.
RULE NUMBER penHalfWidth(NUMBER halfWidth) {
  return max(halfWidth, 0.5f);
}
RULE NUMBER penOpacity(NUMBER halfWidth) {
  return min(2.0f * halfWidth, 1.0f);
}

// Returns by how many pixels the pen's middle lies outside the contour that it draws, so that the
// stroke lies beside the surface and not across its edge.
RULE NUMBER penOutside(NUMBER halfWidth) {
  return max(halfWidth - 0.5f, 0.0f);
}

#ifndef NUMBER_IS_WIDE
// Strokes of cut faces run along whole stripe numbers, of which the odd ones enter and are that
// share as wide. These return whether the nearest one is odd (1 or 0), half of its width and how
// many pixels away it is; `perPixel` is how many stripes a pixel holds.
RULE float stripeIsOdd(float stripe) {
  float nearest = floor(stripe + 0.5f);
  return nearest - 2.0f * floor(0.5f * nearest);
}
RULE float stripeHalfWidth(float stripe, float halfWidth, float oddShare) {
  return halfWidth * (1.0f - stripeIsOdd(stripe) * (1.0f - oddShare));
}
RULE float stripeAway(float stripe, float perPixel) {
  return abs(stripe - floor(stripe + 0.5f)) / max(perPixel, 1e-6f);
}
// Returns the coverage by such strokes.
RULE float stripeCoverage(float stripe, float perPixel, float halfWidth, float oddShare) {
  float width = stripeHalfWidth(stripe, halfWidth, oddShare);
  return penCoverage(penHalfWidth(width), stripeAway(stripe, perPixel), 1.0f) * penOpacity(width);
}
#endif
