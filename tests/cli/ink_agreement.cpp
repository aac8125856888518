// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/ink_agreement.h"

namespace sline::test {

namespace {

bool isInk(const Pixels& picture, int x, int y) {
  const unsigned char* p = picture.at(x, y);
  return p[0] + p[1] + p[2] < 3 * 128;
}

/// Tells whether there is at least half a pixel's ink within 1.5 px: a line as wide as a pixel that
/// lies between two rows is grey in both, which some programs avoid and others do not.
bool inkNear(const Pixels& picture, int x, int y) {
  int ink = 0;
  // All neighbours are within 1.5 px, and nothing else is.
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (x + dx >= 0 && y + dy >= 0 && x + dx < picture.width && y + dy < picture.height) {
        const unsigned char* p = picture.at(x + dx, y + dy);
        ink += 3 * 255 - (p[0] + p[1] + p[2]);
      }
  return ink >= 3 * 127;
}

}  // namespace

Agreement agreement(const Pixels& from, const Pixels& to) {
  Agreement found;
  int near = 0;
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      if (!isInk(from, x, y))
        continue;
      ++found.ink;
      near += inkNear(to, x, y);
    }
  found.share = found.ink > 0 ? double(near) / found.ink : 0.0;
  return found;
}

}  // namespace sline::test
