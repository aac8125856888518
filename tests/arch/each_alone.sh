#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# each_alone.sh SOURCE_DIR: checks that every source file and every public header compiles by
# itself, without warnings, leaning neither on neighbours it is compiled together with nor on
# precompiled headers. Compilers only read here; the other builds make code.
set -euo pipefail
top=$1
build=$top/build/alone
jobs=$(nproc)
cmake -S "$top" --preset alone -DSLINE_TESTS=ON >/dev/null
# These are included by the sources and written by programs: moc's files, shaders, tables, headers
# alone.
mapfile -t made < <(ninja -C "$build" -t targets all |
  sed -n 's/^\([^/:][^:]*\(autogen\/timestamp\|shader_files\.cpp\)\): .*/\1/p' | sort -u)
ninja -C "$build" "${made[@]}" >/dev/null

# Each line is a command without its output.
sed -n 's/^ *"command": "\(.*\)",$/\1/p' "$build/compile_commands.json" |
  sed 's/\\"/"/g; s/\\\\/\\/g; s/ -o [^ ]* -c / -fsyntax-only /' |
  grep -v -e 'mocs_compilation' -e 'qrc_[^ ]*$' -e 'cmake_pch' |
  tr '\n' '\0' | (cd "$build" && xargs -0 -n 1 -P "$jobs" bash -c 'eval "$0" || { echo "in: ${0##* }"; exit 1; }')
