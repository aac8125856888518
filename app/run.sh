#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds, and shows the demo.
#   app/run.sh               opens the window on the demo; without a display draws it to a picture, and
#                            the last line printed is that picture's absolute path
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
cmake --build "$build" --target sline sline-workstation sline-reader >&2

program="$build/bin/sline"
if [ "${1:-}" = --build-only ]; then
  echo "$program"
  exit 0
fi
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$build/bin/sline-workstation" --demo pelvis
fi
echo "There is no display; the demo is drawn to a picture instead." >&2
picture="$build/pelvis.png"
"$program" demo pelvis -o "$picture" >&2
echo "$picture"
