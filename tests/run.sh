#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds and runs every functional test; arguments go to ctest. Checks of
# the code by other means (sanitizers, fuzzing, clang-tidy) are in tests/thorough.sh.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

"$top/app/install-packages.sh" --tests
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$top" --preset release -DSLINE_TESTS=ON "${launcher[@]}"
cmake --build "$top/build/release" --parallel "$jobs"
ctest --test-dir "$top/build/release" --output-on-failure --parallel "$jobs" "$@"
