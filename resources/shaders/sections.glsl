// SPDX-License-Identifier: Apache-2.0
// Section planes as (unit normal, −offset).
#include "cuts.glsl"
uniform vec4 sections[8];
uniform int sectionCount;

bool cutAway(vec3 p) {
  for (int i = 0; i < sectionCount; ++i)
    if (takesAway(sections[i], p))
      return true;
  return false;
}
