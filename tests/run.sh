#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds and passes every test; arguments go to ctest and then only the
# release build is tested.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

"$top/app/install-packages.sh"
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)

build() { # preset target...
  local preset=$1
  shift
  cmake -S "$top" --preset "$preset" -DSLINE_TESTS=ON "${launcher[@]}"
  cmake --build "$top/build/$preset" --parallel "$jobs" --target "$@"
}

# Every public header must compile alone, so their check is part of the build.
build release all all_verify_interface_header_sets
if [ $# -gt 0 ]; then
  exec ctest --test-dir "$top/build/release" --output-on-failure "$@"
fi

# The rooms that read untrusted files and run mathematics on them, and the window, under
# AddressSanitizer, UndefinedBehaviorSanitizer and, where the system lets it look, LeakSanitizer.
build asan sanitized_tests
leaks=1
if "$top/build/asan/bin/bounding_sphere_test" 2>&1 | grep -q "LeakSanitizer has encountered a fatal error"; then
  echo "This system does not let LeakSanitizer look at a process: leaks are not checked." >&2
  leaks=0
fi
ASAN_OPTIONS=detect_leaks=$leaks UBSAN_OPTIONS=print_stacktrace=1 \
  LSAN_OPTIONS=suppressions=$top/tests/leaks.supp:print_suppressions=0 \
  ctest --test-dir "$top/build/asan" --output-on-failure --parallel "$jobs" -L sanitized

ctest --test-dir "$top/build/release" --output-on-failure --parallel "$jobs" -LE sanitized_alone

# A look for input that breaks a reader; what it once found is among the tests above.
"$top/tests/fuzz/run.sh" 120
