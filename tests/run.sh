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

# The rooms that read untrusted files and run mathematics on them, under the sanitizers.
build asan sanitized_tests
"$top/tests/sanitized.sh" "$top/build/asan" '^sanitized$'

ctest --test-dir "$top/build/release" --output-on-failure --parallel "$jobs"

# A look for input that breaks a reader; what it once found is among the tests above.
"$top/tests/fuzz/run.sh" 120

# The quicker half of the window's tests under the sanitizers, half an hour on two cores. CI ends a
# run after 90 minutes; what has taken most of them already leaves this to whoever changed the window.
latest=$((55 * 60))
if [ "$SECONDS" -gt "$latest" ]; then
  echo "NOT RUN: the window's tests under the sanitizers, for $((SECONDS / 60)) minutes are gone." \
    "By hand: tests/sanitized.sh (its head says how)." >&2
  exit 0
fi
build asan sanitized_half_window_tests
"$top/tests/sanitized.sh" "$top/build/asan" '^sanitized_half_window$'
