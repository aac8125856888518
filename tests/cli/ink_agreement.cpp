// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/ink_agreement.h"

namespace sline::test {

namespace {

bool isInk(const Pixels& picture, int x, int y) {
  const unsigned char* p = picture.at(x, y);
  return p[0] + p[1] + p[2] < 3 * 128;
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
      bool met = false;
      // All neighbours are within 1.5 px, and nothing else is.
      for (int dy = -1; dy <= 1 && !met; ++dy)
        for (int dx = -1; dx <= 1 && !met; ++dx)
          met = x + dx >= 0 && y + dy >= 0 && x + dx < to.width && y + dy < to.height &&
                isInk(to, x + dx, y + dy);
      near += met;
    }
  found.share = found.ink > 0 ? double(near) / found.ink : 0.0;
  return found;
}

}  // namespace sline::test
