// SPDX-License-Identifier: Apache-2.0
#include "model/import/worker/confinement.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <new>

namespace sline::model {

namespace {

#if defined(__x86_64__)
constexpr unsigned machine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned machine = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned machine = 0;
#endif

void limit(__rlimit_resource resource, std::uint64_t amount) {
  // The kernel kills at the higher one without saying which limit it was.
  const rlimit value{amount, amount + 1};
  setrlimit(resource, &value);
}

[[noreturn]] void endForMemory() {
  _exit(outOfMemoryStatus);
}

constexpr sock_filter load(std::size_t offset) {
  return {BPF_LD | BPF_W | BPF_ABS, 0, 0, unsigned(offset)};
}
/// Jumps over `over` instructions where the loaded number is `value`, and on to the next one
/// otherwise.
constexpr sock_filter jumpIf(unsigned value, unsigned char over) {
  return {BPF_JMP | BPF_JEQ | BPF_K, over, 0, value};
}
constexpr sock_filter answer(unsigned value) {
  return {BPF_RET | BPF_K, 0, 0, value};
}

/// Makes the kernel answer "not permitted" to the calls listed.
void refuseCalls() {
  if (machine == 0 || prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0)
    return;
  sock_filter program[] = {
      load(offsetof(seccomp_data, arch)),
      jumpIf(machine, 1),
      answer(SECCOMP_RET_KILL_PROCESS),
      load(offsetof(seccomp_data, nr)),
      jumpIf(__NR_socket, 6),
      jumpIf(__NR_connect, 5),
      jumpIf(__NR_execve, 4),
      jumpIf(__NR_execveat, 3),
      jumpIf(__NR_ptrace, 2),
      jumpIf(__NR_process_vm_writev, 1),
      answer(SECCOMP_RET_ALLOW),
      answer(SECCOMP_RET_ERRNO | EPERM),
  };
  const sock_fprog filter{sizeof(program) / sizeof(*program), program};
  prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}
}  // namespace

void confineThisProcess(const ConfinementLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.seconds);
  limit(RLIMIT_FSIZE, limits.memoryBytes);
#if !defined(__SANITIZE_ADDRESS__)
  // AddressSanitizer maps terabytes for itself.
  limit(RLIMIT_DATA, limits.memoryBytes);
#endif
  std::set_new_handler(endForMemory);
  refuseCalls();
}

}  // namespace sline::model
