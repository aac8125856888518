#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang_tidy.sh SOURCE_DIR BUILD_DIR: checks that clang-tidy reports nothing about model and render.
# Nearly all its time goes into the standard library's headers, which every source file brings
# again; so four neighbours are checked as one. If it reports something about the four, or they
# cannot stand together (two have a name in common), each is checked alone, and that result counts.
# Only an unused using-declaration is not seen in company. The path-sensitive analyzer, which
# takes three times as long as all other checks together, is left to editors and to runs by hand.
# Two kinds of sources are left out: gemmi and qpdf declare vectors of a class before it is
# complete, which clang 14 and libstdc++ 12 do not compile together.
set -euo pipefail
cd "$1"
command -v clang-tidy >/dev/null || { echo "clang-tidy is not installed"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export build=$2 scratch

# unit.N.cpp includes neighbours that are compiled alike, unit.N.flags says how. g++'s own options
# do not concern clang.
awk -v top="$PWD" -v out="$scratch" '
  /^ *"command": / { command = $0 }
  /^ *"file": / {
    file = $0
    gsub(/^ *"file": "|",?$/, "", file)
    if (index(file, top "/model/") != 1 && index(file, top "/render/") != 1) next
    if (file ~ /\/(molecules\/cif_rows|pdf\/pdf_(document|fonts|navigation|tags))\.cpp$/) next
    count = split(command, word, " ")
    flags = ""
    for (i = 1; i <= count; ++i)
      if (word[i] ~ /^-(I|D|std=)/) flags = flags " " word[i]
      else if (word[i] == "-isystem") flags = flags " -isystem " word[++i]
    folder = file
    sub(/[^\/]*$/, "", folder)
    if (members == 4 || folder flags != last) { ++unit; members = 0; last = folder flags }
    ++members
    print "#include \"" file "\"" > (out "/unit." unit ".cpp")
    print flags > (out "/unit." unit ".flags")
  }' "$build/compile_commands.json"

check() { # unit.N.cpp
  local flags files
  flags=$(head -n 1 "${1%.cpp}.flags")
  # shellcheck disable=SC2086  # several words
  clang-tidy "$1" --quiet --config-file=.clang-tidy --header-filter='/(model|render)/.*' \
    --checks='-clang-analyzer-*,-bugprone-suspicious-include' -- $flags >/dev/null 2>&1 && return
  mapfile -t files < <(sed 's/^#include "\(.*\)"$/\1/' "$1")
  echo "alone: ${files[*]#"$PWD/"}"
  clang-tidy -p "$build" --quiet --checks='-clang-analyzer-*' \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-unused-command-line-argument \
    "${files[@]}"
}
export -f check
find "$scratch" -name 'unit.*.cpp' -print0 | xargs -0 -n 1 -P "$(nproc)" bash -c 'check "$0"'
