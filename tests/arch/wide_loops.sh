#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fails where compilers do not reckon with eight numbers at once in a function for which they are
# asked to (SLINE_WIDE_LOOPS): they say nothing when they give up. Takes a program that is optimised.
set -euo pipefail

program=$1
command -v objdump > /dev/null || exit 77
if ! grep -q "clone .avx2" <(nm -C "$program"); then
  echo "The program has no such functions: it is for another processor, or is checked as it runs."
  exit 77
fi
objdump --disassemble --no-show-raw-insn --demangle "$program" | awk '
  /^[0-9a-f]+ <.*>:$/ {
    wanted = index($0, "[clone .avx2")
    name = $0
    if (wanted) functions[name] += 0
  }
  wanted && /\tv[a-z0-9]*(add|sub|mul|div|sqrt|min|max|cmp|cvt)[a-z0-9]* .*%ymm/ { ++functions[name] }
  END {
    for (name in functions) {
      ++count
      if (functions[name] == 0) {
        print "works on one number at a time: " name
        failed = 1
      }
    }
    print count " functions with wide loops"
    exit failed
  }'
