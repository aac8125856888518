// SPDX-License-Identifier: Apache-2.0
#include "model/disk/process.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

#if defined(__linux__)
#include <sys/resource.h>
#endif
#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace sline::model {

int processNumber() {
  return int(getpid());
}

bool isRunning(int process) {
  return process > 0 && (kill(process, 0) == 0 || errno == EPERM);
}

std::filesystem::path programFile() {
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none);
}

void standBack() {
#if defined(__linux__)
  // On Linux "process" means thread here, and Qt's own priorities have no effect on this scheduler.
  constexpr int lower = 5;
  const auto thread = id_t(gettid());
  static_cast<void>(setpriority(PRIO_PROCESS, thread, getpriority(PRIO_PROCESS, thread) + lower));
#endif
}

void keepStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 &&
        open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) < 0)
      return;
}

bool errorsGoToTerminal() {
  return isatty(STDERR_FILENO) == 1;
}

Result<void*> functionOf(const std::filesystem::path& library, const char* name) {
  void* loaded = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!loaded) {
    const char* reason = dlerror();
    return Error{.file = library.string(), .reason = reason ? reason : "no reason is said"};
  }
  return dlsym(loaded, name);
}

void giveMemoryBack() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace sline::model
