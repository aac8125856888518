// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/background_thread.h"

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace sline::widgets {

void standBack() {
#if defined(__linux__)
  // On Linux "process" means thread here, and Qt's own priorities say nothing to this scheduler.
  constexpr int lower = 5;  // about a third of the share of a thread that does not stand back
  const auto thread = id_t(gettid());
  static_cast<void>(setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + lower));
#endif
}

}  // namespace sline::widgets
