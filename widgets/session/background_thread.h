// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::widgets {

/// From now on the calling thread, and threads that it starts, let others go first where cores are
/// scarce: the window and the display that shows it must not wait for pictures and files. Does
/// nothing where the system knows no such order among threads.
void standBack();

}  // namespace sline::widgets
