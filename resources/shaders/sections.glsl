// SPDX-License-Identifier: Apache-2.0
// Section planes as (unit normal, −offset): everything on the side of the normal is taken away.
uniform vec4 sections[8];
uniform int sectionCount;

bool cutAway(vec3 p) {
  for (int i = 0; i < sectionCount; ++i)
    if (dot(sections[i], vec4(p, 1.0)) > 0.0)
      return true;
  return false;
}
