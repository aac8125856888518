// SPDX-License-Identifier: Apache-2.0
// Finds which contours their own surface hides; for capsule.glsl.
uniform vec2 reach;   // px at which a contour's far side is looked for: a small and a wide step
flat in vec2 lineLifts;  // window depth of twice the tolerance, and of `sheet` (ink.vert.glsl)

// Within a step of a contour its own surface falls away from the eye or ends, while a hidden
// contour has something nearer on both sides. Where a surface is seen along its length, its
// triangles' outline may lie a few pixels outside the line: there, and only if the same sheet hides
// the line, a wider step counts.
bool contourVisible(Capsule c, vec2 outward, out float wide) {
  wide = 0.0;
  float here = depthAt(c.on);
  if (inSight(c, max(here, depthAt(c.on + reach.x * outward))))
    return true;
  if (c.depth - lineLifts.y > here)
    return false;
  wide = reach.y;
  return inSight(c, max(depthAt(c.on + 0.5 * (reach.x + reach.y) * outward),
                        depthAt(c.on + reach.y * outward)));
}
