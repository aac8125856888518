// SPDX-License-Identifier: Apache-2.0
// What section planes take away, and where the faces lie that they cut. See rules.h for what may be
// written here.
#ifndef RULE
#define RULE
#define CONSTANT const
#endif

// Tells whether a plane, (unit normal, −offset), takes a place away: all on its normal's side.
RULE bool takesAway(vec4 plane, vec3 place) {
  return dot(plane, vec4(place, 1.0f)) > 0.0f;
}

// Returns the window depth of a cut face's plane at a place in the picture, counted in pixels from
// the picture's middle. Depth comes from the plane and not from triangles, so that faces of several
// structures on one plane lie exactly equally deep.
RULE float faceDepth(vec3 depthPlane, vec2 fromMiddle) {
  return clamp(dot(depthPlane, vec3(fromMiddle, 1.0f)), 0.0f, 1.0f);
}
