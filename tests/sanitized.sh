#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# sanitized.sh BUILD_DIR LABEL: runs the tests of that label (a regular expression) in a build of
# the preset "asan", under AddressSanitizer, UndefinedBehaviorSanitizer and, if the system lets it
# look, LeakSanitizer. All of the window's tests, half an hour on two cores:
#   cmake --preset asan -DSLINE_TESTS=ON && cmake --build build/asan --target sanitized_window_tests
#   tests/sanitized.sh build/asan sanitized_window
set -euo pipefail

build=${1:?which build}
label=${2:?which label}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
leaks=1
probe=$("$build/bin/model_tests" bounding_sphere_test 2>&1 || true)
if [[ $probe == *"LeakSanitizer has encountered a fatal error"* ]]; then
  echo "This system does not let LeakSanitizer look at a process: leaks are not checked." >&2
  leaks=0
fi
ASAN_OPTIONS=detect_leaks=$leaks UBSAN_OPTIONS=print_stacktrace=1 \
  LSAN_OPTIONS=suppressions=$here/leaks.supp:print_suppressions=0 \
  ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" -L "$label"
