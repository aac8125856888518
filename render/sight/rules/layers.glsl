// SPDX-License-Identifier: Apache-2.0
// How the layers of a pixel become its colour (METHOD §10, §11.6). See rules.h for what may be
// written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif
#ifndef NUMBER
#define NUMBER float
#endif

// What is laid in front hides all behind it from this opacity on.
CONSTANT float hidesAll = 0.998f;
// Lines that show through what lies before them have this share of their ink.
CONSTANT float hiddenShare = 0.5f;
// A layer stores this share of the coverage of its hidden lines, and above the next number that it
// keeps lines behind it away.
CONSTANT float hiddenStored = 0.5f;
CONSTANT float haloAbove = 0.75f;

// Returns a channel of a colour over another; both are premultiplied but for `opacity`.
RULE NUMBER layered(NUMBER above, float opacity, NUMBER below) {
  return above * opacity + below * (1.0f - opacity);
}

// Returns what shows of a sum of nearer layers, of that opacity, and of another layer behind them;
// premultiplied.
RULE NUMBER laidBehind(NUMBER nearer, float opacity, NUMBER colour) {
  return nearer + colour * (1.0f - opacity);
}

#ifndef NUMBER_IS_WIDE
// Tells whether a layer lies before another: of two equally deep ones the first in order.
RULE bool liesBefore(float depth, float order, float otherDepth, float otherOrder) {
  return depth < otherDepth || (depth == otherDepth && order < otherOrder);
}

// Returns the coverage by hidden lines that a stored value stands for.
RULE float hiddenCoverage(float stored) {
  return stored > haloAbove ? 0.0f : min(stored / hiddenStored, 1.0f) * hiddenShare;
}
#endif
