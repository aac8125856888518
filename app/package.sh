#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds the programs and makes two packages of them: one for Debian, and an archive that brings its
# libraries along and runs from any folder. The last two lines printed are their absolute paths;
# everything else goes to standard error.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build="$top/build/release"

if [ $# -gt 0 ]; then
  echo "usage: app/package.sh" >&2
  exit 2
fi

"$top/app/install-packages.sh" --package
"$top/app/run.sh" --build-only >&2
rm -rf "$build/packages"
(cd "$build" && cpack --config CPackConfig.cmake) >&2
ls "$build"/packages/sline_*.deb
ls "$build"/packages/sline-*.tar.gz
