#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# web_shared.sh SOURCE_DIR: checks that the sources of the web page compile with clang as well, and
# read no header of Qt, VTK, OpenMesh, oneTBB or OpenImageIO on the way.
set -euo pipefail
cd "$1"
command -v clang++ >/dev/null || { echo "clang++ is not installed"; exit 77; }
# render/web itself is for Emscripten alone.
mapfile -t rooms < <(grep -oE '(model|render)/[a-z_]+' render/web/rooms.cmake | grep -v '^render/web$')
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export scratch

# libstdc++ brings oneTBB in by itself, for std::execution, where its headers are installed.
export flags="-std=c++20 -I. -D_GLIBCXX_USE_TBB_PAR_BACKEND=0"

check() {
  local source=$1
  local seen="$scratch/${source//\//_}.d"
  # shellcheck disable=SC2086  # several words
  clang++ $flags -fsyntax-only -Wall -Wextra -Werror -Wno-missing-field-initializers "$source" ||
    return 1
  # -fsyntax-only writes no dependencies; the preprocessor does.
  clang++ $flags -M -MF "$seen" "$source"
  if grep -E '/(qt6|vtk-?[0-9.]*|OpenMesh|tbb|oneapi|OpenImageIO)/' "$seen"; then
    echo "$source reads a header that the web page cannot have"
    return 1
  fi
}
export -f check

# Threads and the headless context belong to the desktop alone.
find "${rooms[@]}" -name '*.cpp' ! -name 'parallel_tbb.cpp' ! -path '*/headless/*' -print0 |
  xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$0"'
