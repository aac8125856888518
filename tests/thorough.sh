#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# thorough.sh [PART...]: checks the code beyond the functional tests; without names in all parts.
#   alone      every source and public header compiles by itself, and the shared rooms with clang
#   tidy       clang-tidy
#   sanitized  tests of reading files and computing on them, under AddressSanitizer and its like
#   window     the quicker half of the window's tests under the sanitizers (tests/sanitized.sh: all)
#   fuzz       two minutes of libFuzzer
#   package    both packages are made, and the programs run from them
#   office     LibreOffice, where it is installed, opens fifty presentations
# With SLINE_MINUTES=50 it begins no part that would not end within 50 minutes of the shell's
# SLINE_BEGAN (seconds since 1970), takes them in an order that changes with the commit, so that a few
# runs cover everything, and says what it has left out.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
jobs=$(nproc)

# Name and minutes on two cores without a compiler cache.
parts=("alone 16" "sanitized 20" "tidy 12" "window 25" "fuzz 9" "package 7" "office 5")
if [ $# -gt 0 ]; then
  for name in "$@"; do
    printf '%s\n' "${parts[@]}" | grep -q "^$name " || {
      echo "thorough.sh: no part is called $name" >&2
      exit 2
    }
  done
  parts=("${@/%/ 0}")
fi

"$top/app/install-packages.sh" --tests
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)

sanitized_build() { # target...
  cmake -S "$top" --preset asan -DSLINE_TESTS=ON "${launcher[@]}" >/dev/null
  cmake --build "$top/build/asan" --parallel "$jobs" --target "$@"
}

run() { # part
  case $1 in
    alone)
      "$top/tests/arch/each_alone.sh" "$top"
      bash "$top/tests/arch/web_shared.sh" "$top"
      ;;
    tidy)
      cmake -S "$top" --preset alone -DSLINE_TESTS=ON >/dev/null
      bash "$top/tests/arch/clang_tidy.sh" "$top" "$top/build/alone"
      ;;
    sanitized)
      sanitized_build sanitized_tests
      "$top/tests/sanitized.sh" "$top/build/asan" '^sanitized$'
      ;;
    window)
      sanitized_build sanitized_window_tests
      "$top/tests/sanitized.sh" "$top/build/asan" '^sanitized_half_window$'
      ;;
    fuzz) "$top/tests/fuzz/run.sh" 120 ;;
    package) "$top/tests/package/package_test.sh" ;;
    office)
      cmake -S "$top" --preset release -DSLINE_TESTS=ON "${launcher[@]}" >/dev/null
      cmake --build "$top/build/release" --parallel "$jobs" --target render_tests
      SLINE_OFFICE=1 ctest --test-dir "$top/build/release" --output-on-failure -R '^slide_office_test$'
      ;;
  esac
}

left_out=()
began=${SLINE_BEGAN:-$(date +%s)}
first=0
if [ -n "${SLINE_MINUTES:-}" ]; then
  commit=$(git -C "$top" rev-parse HEAD 2>/dev/null || echo 0)
  first=$((16#${commit:0:6} % ${#parts[@]}))
fi
for ((i = 0; i < ${#parts[@]}; ++i)); do
  read -r name minutes <<<"${parts[(first + i) % ${#parts[@]}]}"
  gone=$((($(date +%s) - began) / 60))
  if [ -n "${SLINE_MINUTES:-}" ] && [ $((gone + minutes)) -gt "$SLINE_MINUTES" ]; then
    left_out+=("$name")
    continue
  fi
  echo "== $name"
  part_began=$SECONDS
  run "$name"
  echo "== $name: passed in $(((SECONDS - part_began + 59) / 60)) minutes"
done
[ ${#left_out[@]} -eq 0 ] || echo "Left out, as $SLINE_MINUTES minutes would not do: ${left_out[*]}." \
  "By hand: tests/thorough.sh ${left_out[*]}"
