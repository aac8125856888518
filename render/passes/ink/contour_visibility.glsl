// SPDX-License-Identifier: Apache-2.0
// Finds which contours their own surface hides; for capsule.glsl.
uniform vec2 reach;   // px at which a contour's far side is looked for: a small and a wide step
uniform float sheet;  // mm by which a surface may hide a line of its own sheet

// Within a step of a contour its own surface falls away from the eye or ends, while a hidden
// contour has something nearer on both sides. Where a surface is seen along its length, its
// triangles' outline may lie a few pixels outside the line: there, and only if the same sheet hides
// the line, a wider step counts.
bool contourVisible(Capsule c, vec2 outward, out float wide) {
  wide = 0.0;
  float here = depthAt(c.on);
  float behind = max(here, depthAt(c.on + reach.x * outward));
  float distance = eyeDistance(c.depth, projection);
  if (distance <= eyeDistance(behind, projection) + lineDepths.z)
    return true;
  if (distance > eyeDistance(here, projection) + sheet)
    return false;
  wide = reach.y;
  behind = max(depthAt(c.on + 0.5 * (reach.x + reach.y) * outward),
               depthAt(c.on + reach.y * outward));
  return distance <= eyeDistance(behind, projection) + lineDepths.z;
}
