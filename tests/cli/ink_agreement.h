// SPDX-License-Identifier: Apache-2.0
// Measures whether two programs draw the same lines.
#pragma once

#include "tests/cli/sline_process.h"

namespace sline::test {

struct Agreement {
  double share = 0.0;  ///< share of the ink that has ink of the other within 1.5 px
  int ink = 0;         ///< in pixels
};
/// Compares ink, which is anything darker than mid-grey.
Agreement agreement(const Pixels& from, const Pixels& to);

}  // namespace sline::test
