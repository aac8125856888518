#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh SECONDS [HARNESS...]: builds sline-fuzz and lets the harnesses (all, if none is named) run
# for that long together, one to a core. Fails at the first input that crashes, takes longer than
# 5 s (molecules: see below) or more than 2 GB; it then lies in build/fuzz/findings. The corpus
# grows in build/fuzz/corpus from run to run; small files of the folder SLINE_TEST_DATA are seeds
# as well.
set -euo pipefail

seconds=${1:?how many seconds}
shift
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)
build=$top/build/fuzz
jobs=$(nproc)

launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$top" --preset fuzz "${launcher[@]}" >/dev/null
cmake --build "$build" --parallel "$jobs" --target sline-fuzz

program=$build/bin/sline-fuzz
names=("$@")
# Without a harness's name it lists them.
[ ${#names[@]} -gt 0 ] || mapfile -t names < <("$program" 2>/dev/null || true)
each=$((seconds * jobs / ${#names[@]}))
[ "$each" -ge 1 ] || each=1

memory=/dev/shm
[ -w "$memory" ] || memory=${TMPDIR:-/tmp}
scratch=$(mktemp -d -p "$memory")
trap 'rm -rf "$scratch"' EXIT
export here build program each TMPDIR=$scratch
export ASAN_OPTIONS=quarantine_size_mb=64 UBSAN_OPTIONS=print_stacktrace=1

fuzz() { # harness
  local name=$1
  local log=$build/logs/$name.log
  local inputs=("$build/corpus/$name" "$here/seeds/$name")
  [ -d "$here/crashers/$name" ] && inputs+=("$here/crashers/$name")
  mkdir -p "$build/logs" "$build/findings" "$build/corpus/$name"
  if [ -d "${SLINE_TEST_DATA:-}" ]; then
    local data=$scratch/$name
    mkdir -p "$data"
    find -L "$SLINE_TEST_DATA" -iname "*.$name" -size -64k -print0 |
      xargs -0 -r cp --backup=numbered -t "$data"
    inputs+=("$data")
  fi
  # Surfaces of molecules, which are arithmetic through and through, take forty times as long with
  # sanitizers as without: 18 s instead of 0.45 s.
  local limit=5
  case $name in pdb | cif | cif_gz | json | assembly) limit=60 ;; esac
  local options=(-max_total_time="$each" -max_len=1048576 -timeout="$limit" -rss_limit_mb=2048
    -malloc_limit_mb=2048 -print_final_stats=1 -artifact_prefix="$build/findings/$name-")
  [ -f "$here/dictionaries/$name.dict" ] && options+=(-dict="$here/dictionaries/$name.dict")
  local rc=0
  SLINE_HARNESS=$name "$program" "${options[@]}" "${inputs[@]}" >"$log" 2>&1 || rc=$?
  # These are from the last line of progress and the final statistics.
  awk -v name="$name" -v rc="$rc" '
    { for (i = 1; i < NF; ++i) {
        if ($i == "cov:") cov = $(i + 1)
        if ($i == "corp:") corp = $(i + 1) } }
    /^stat::number_of_executed_units/ { runs = $2 }
    /^stat::average_exec_per_sec/ { rate = $2 }
    /^stat::peak_rss_mb/ { rss = $2 }
    END { printf "%-14s %10d %8d %9d %14s %7d MB  %s\n", name, runs, rate, cov, corp, rss,
          rc == 0 ? "" : "FOUND, see " name ".log" }' "$log"
  if [ "$rc" -ne 0 ]; then
    grep -E 'SLINE FAULT|SUMMARY|Test unit written|runtime error' "$log" || tail -n 5 "$log"
    return 1
  fi
}
export -f fuzz
export scratch

printf '%-14s %10s %8s %9s %14s %10s\n' harness runs exec/s coverage corpus 'peak rss'
printf '%s\0' "${names[@]}" | xargs -0 -n 1 -P "$jobs" bash -c 'fuzz "$0"'
