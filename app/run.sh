#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and shows the demo.
#   app/run.sh               the last line printed is the absolute path of the demo's picture
#   app/run.sh --build-only  the last line printed is the absolute path of the sline program
# Everything else goes to standard error.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$top/build/release"

case "${1:-}" in
  "" | --build-only) ;;
  *)
    echo "usage: app/run.sh [--build-only]" >&2
    exit 2
    ;;
esac

"$top/app/install-packages.sh"
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$top" --preset release -DSLINE_TESTS=OFF "${launcher[@]}" >&2
cmake --build "$build" --target sline >&2

program="$build/bin/sline"
if [ "${1:-}" = --build-only ]; then
  echo "$program"
  exit 0
fi
picture="$build/kidney.png"
"$program" demo kidney -o "$picture" >&2
[ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] &&
  echo "This version has no window yet; the demo was rendered to a picture." >&2
echo "$picture"
