// SPDX-License-Identifier: Apache-2.0
// Measures where two pictures look different, which edges that lie a little apart do not.
#pragma once

#include "tests/cli/sline_process.h"

namespace sline::test {

struct Blobs {
  double share = 0.0;  ///< of the picture, 0 … 1
  int count = 0;
  double largest = 0.0;  ///< the largest difference of a channel anywhere, 0 … 1
};
/// Returns the connected areas of 16 pixels or more in which a channel differs by more than a tenth
/// once the difference is blurred by a Gaussian of 2 pixels. Clear pixels count as white. Both
/// pictures are of one size.
Blobs differingBlobs(const Pixels& a, const Pixels& b);

}  // namespace sline::test
