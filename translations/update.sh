#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Brings the .ts files up to date with the texts in the program; what is new in them is unfinished.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
lupdate=/usr/lib/qt6/bin/lupdate  # where Debian keeps it
for language in de_DE nb_NO nl_NL; do
  "$lupdate" -I . -silent -locations none -no-obsolete widgets render/export app/main.cpp \
    -ts "translations/sline_${language%_*}.ts" -target-language "$language"
done
"$lupdate" -I . -silent -locations none -no-obsolete -pluralonly widgets render/export app/main.cpp \
  -ts translations/sline_en.ts -target-language en_US
