// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::widgets {

/// The height of a presented picture in heights of its letters, which can be read from the last
/// row.
inline constexpr int presentedLines = 40;

}  // namespace sline::widgets
