#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Measures the scenes named, makes the guide's page about speed and keeps the reports:
#   performance.sh SLINE_BENCH REPORTS GROWING.ply [NAME=SCENE…]
# GROWING is a closed surface of some tens of thousands of triangles; it is measured as it is and
# after one to four subdivisions. The machine must have nothing else to do.
set -euo pipefail

usage="usage: performance.sh SLINE_BENCH REPORTS GROWING.ply [NAME=SCENE…]"
bench=$(realpath "${1:?$usage}")
mkdir -p "${2:?$usage}"
reports=$(realpath "$2")
growing=$(realpath "${3:?$usage}")
shift 3
page=$(dirname "$(realpath "$0")")/../../resources/help/performance.md
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

made=()
measure() { # NAME INPUT FLAGS…
  echo "measuring $1" >&2
  "$bench" "${@:2}" --json > "$reports/$1.json"
  made+=("$reports/$1.json")
}

for times in 0 1 2 3 4; do
  "$bench" "$growing" --subdivided "$times" "$scratch/surface.ply"
  measure "surface $((times + 1))" "$scratch/surface.ply" --gamma 2 --frames $((times > 2 ? 12 : 60))
done
for scene in "$@"; do
  measure "${scene%%=*}" "${scene#*=}"
done
"$bench" "${made[@]}" --page "$page"
