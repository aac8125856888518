#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_tidy.sh SOURCE_DIR BUILD_DIR: clang-tidy has nothing to say of model and render. The
# path-sensitive analyzer, which takes three times as long as all other checks together, is left to
# editors and to runs by hand.
set -euo pipefail
cd "$1"
command -v clang-tidy >/dev/null || { echo "clang-tidy is not installed"; exit 77; }
# g++'s own options are not clang's business.
find model render -name '*.cpp' ! -name 'parallel_serial.cpp' -print0 |
  xargs -0 -n 4 -P "$(nproc)" clang-tidy -p "$2" --quiet --checks='-clang-analyzer-*' \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-unused-command-line-argument
