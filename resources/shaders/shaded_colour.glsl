// SPDX-License-Identifier: Apache-2.0
#include "shade.glsl"

// Returns the colour in that light.
vec3 shadedColour(vec3 colour, float light, float glint) {
  vec3 shadow = inShadow(colour);
  return vec3(shaded(shadow.r, colour.r, light, glint), shaded(shadow.g, colour.g, light, glint),
              shaded(shadow.b, colour.b, light, glint));
}
