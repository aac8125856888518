// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/known_lines.h"

namespace sline::test {

/// Finds lines that depend on the view from the sheet's formula on a fine grid.
std::vector<LineSample> linesOnGrid(const KnownSheet& sheet, const KnownRequest& request);

}  // namespace sline::test
