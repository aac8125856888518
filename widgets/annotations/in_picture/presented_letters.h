// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::widgets {

/// So many letters' heights make a presented picture's: what can be read from the last row.
inline constexpr int presentedLines = 40;

}  // namespace sline::widgets
