// SPDX-License-Identifier: Apache-2.0
// Which lines their own surface leaves in sight (METHOD §10, §11). See rules.h for what may be
// written here. Depths may be window depths or distances from the eye.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif

// A contour is looked for up to four times, farther and farther outside it: within a small step its
// own surface falls away from the eye or ends, while a hidden contour has something nearer on both
// sides. Where a surface is seen along its length, its triangles' outline may lie a few pixels
// outside the line: there, and only if the same sheet hides the line, wider steps count.
// Returns how far outside the k-th look is, in pixels; `reach` holds the small and the wide step.
RULE float lookOutside(int k, vec2 reach) {
  return k == 0 ? 0.0f : k == 1 ? reach.x : k == 2 ? 0.5f * (reach.x + reach.y) : reach.y;
}

CONSTANT int lookedEnough = 4;
CONSTANT int lineSeen = -1;

// Tells whether a surface hides no line that is at most so much deeper.
RULE bool leavesInSight(float surface, float line, float tolerance) {
  return line - tolerance <= surface;
}

// Returns what the k-th look, which found a surface at that depth, tells of a contour: `lineSeen`,
// the number of the next look, or `lookedEnough` where it is hidden. `here` is the surface's depth
// at the contour itself; `slack` holds the tolerance and by how much its own sheet may hide it.
RULE int afterLook(int k, float surface, float line, float here, vec2 slack) {
  if (leavesInSight(surface, line, slack.x))
    return lineSeen;
  return k == 3 || (k == 1 && line - slack.y > here) ? lookedEnough : k + 1;
}

// Returns how far outside a contour its surface is looked for if the k-th look saw it: where it goes
// on there, the contour lies within the structure's own mask.
RULE float probeOutside(int k, float probe, vec2 reach) {
  return probe + (k > 1 ? reach.y : 0.0f);
}
