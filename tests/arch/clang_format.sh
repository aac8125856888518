#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_format.sh SOURCE_DIR: checks that every C++ file is in clang-format's shape.
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is not installed"; exit 77; }
find app model render tests widgets \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -n 40 -P "$(nproc)" clang-format --dry-run -Werror
