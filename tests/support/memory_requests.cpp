// SPDX-License-Identifier: Apache-2.0
#include "tests/support/memory_requests.h"

#include <cstddef>

namespace {
thread_local std::uint64_t requests = 0;
}

namespace sline::test {

std::uint64_t memoryRequests() {
  return requests;
}

}  // namespace sline::test

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

// The sanitizer's allocator calls these, if they are there.
extern "C" {
void __sanitizer_malloc_hook(const volatile void*, std::size_t) {
  ++requests;
}
void __sanitizer_free_hook(const volatile void*) {}
}

#else

// The program's own functions go before those of the C library, which does the work under the names
// that it keeps for this.
extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* there, std::size_t bytes);

void* malloc(std::size_t bytes) {
  ++requests;
  return __libc_malloc(bytes);
}
void* calloc(std::size_t count, std::size_t bytes) {
  ++requests;
  return __libc_calloc(count, bytes);
}
void* realloc(void* there, std::size_t bytes) {
  ++requests;
  return __libc_realloc(there, bytes);
}
}

#endif
