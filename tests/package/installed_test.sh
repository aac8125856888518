#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# installed_test.sh BUILD: installs a finished build into an empty folder and checks it with the
# programs that read desktop entries, metadata, types of files, man pages and completions. Ends with
# 77 (skipped) if one of them is absent, unless SLINE_NOTHING_ABSENT is set.
set -euo pipefail

build=$1
id=org.sline.Sline
for program in desktop-file-validate appstreamcli xmllint update-mime-database gio man groff mandoc zsh fish; do
  command -v "$program" >/dev/null && continue
  echo "$program is absent" >&2
  [ -z "${SLINE_NOTHING_ABSENT:-}" ] && exit 77
  exit 1
done
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
share=$prefix/share
sline=$prefix/bin/sline

fail() {
  echo "installed_test.sh: $*" >&2
  exit 1
}

layout() {
  cmake --install "$build" --prefix "$prefix" >/dev/null
  [ "$(cd "$prefix" && echo bin/*)" = "bin/sline bin/sline-workstation" ] || fail "bin holds something else"
  local file
  for file in applications/$id.desktop kio/servicemenus/$id.folder.desktop \
    nemo/actions/$id.nemo_action metainfo/$id.metainfo.xml mime/packages/$id.xml \
    icons/hicolor/scalable/apps/$id.svg icons/hicolor/scalable/mimetypes/application-x-sline.svg \
    doc/sline/copyright doc/sline/LICENSE bash-completion/completions/sline \
    zsh/site-functions/_sline fish/vendor_completions.d/sline.fish man/man1/sline.1; do
    [ -s "$share/$file" ] || fail "$file is not installed"
  done
  # The pictures that the start page shows at once are drawn where the build is for use.
  if grep -q '^CMAKE_BUILD_TYPE:STRING=Release' "$build/CMakeCache.txt"; then
    [ "$(find "$share/sline/demos" -name '*-v*.png' -size -41k | wc -l)" -eq 5 ] || fail "demos lack pictures"
    [ "$(find "$share/sline/demos" -name 'drawing-*.png' -size -41k | wc -l)" -eq 7 ] || fail "drawing styles lack pictures"
  fi
  [ -s "$prefix/lib/sline/libsline-pixels.so" ] || fail "the part for TIFF and others is not installed"
  "$sline" --version | grep -q '^sline [0-9]' || fail "the installed program does not start"
  # DICOM is read by another program, which sline must find: this file is DICOM, and holds nothing.
  head -c 128 /dev/zero >"$prefix/none.dcm"
  printf DICM >>"$prefix/none.dcm"
  ! "$sline" info "$prefix/none.dcm" 2>"$prefix/said" || fail "an empty DICOM file was read"
  ! grep -q sline-reader "$prefix/said" || fail "$(cat "$prefix/said")"
}

# Modules for pictures other than PNG are found from where the program is installed.
pictures() {
  printf 'v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n' >"$prefix/t.obj"
  "$sline" render "$prefix/t.obj" -o "$prefix/t.tiff" --size 64x64 >/dev/null
  [ "$(head -c 2 "$prefix/t.tiff")" = II ] || fail "no TIFF was written"
}

desktop() {
  local entry=$share/applications/$id.desktop said
  said=$(desktop-file-validate "$entry" | grep -v ': hint: ' || true)
  [ -z "$said" ] || fail "$said"
  [ -x "$prefix/bin/$(sed -n 's/^Exec=\([^ ]*\).*/\1/p' "$entry")" ] || fail "Exec names no program"
  ! grep -q 'inode/directory' "$entry" || fail "the program would become the file manager"
  local menu
  for menu in "$share/kio/servicemenus/$id.folder.desktop" "$share/nemo/actions/$id.nemo_action"; do
    grep -q "^$(grep '^Exec=' "$entry")\$" "$menu" || fail "$menu starts something else"
  done
  [ -s "$share/icons/hicolor/scalable/apps/$(sed -n 's/^Icon=//p' "$entry").svg" ] || fail "no icon"
  appstreamcli validate --no-net "$share/metainfo/$id.metainfo.xml"
  xmllint --noout "$share"/mime/packages/*.xml "$share"/icons/hicolor/scalable/*/*.svg
}

type_of() { # file
  XDG_DATA_HOME=$share gio info -a standard::content-type "$1" | sed -n 's/.*content-type: //p'
}

# A scene is known by its name, and without one by how its file begins.
mime_type() {
  update-mime-database "$share/mime" 2>/dev/null # warns of folders that are not this one
  grep -q '^50:application/x-sline:\*\.sline$' "$share/mime/globs2" || fail "no pattern for .sline"
  grep -q '^50:application/x-mrml:\*\.mrml$' "$share/mime/globs2" || fail "no pattern for .mrml"
  local scene=$prefix/scene.sline
  printf 'solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n%s' \
    $'endfacet\nendsolid t\n' >"$prefix/t.stl"
  "$sline" import "$prefix/t.stl" -o "$scene" >/dev/null 2>&1
  cp "$scene" "$prefix/nameless"
  [ "$(type_of "$scene")" = application/x-sline ] || fail "a scene is not known by its name"
  [ "$(type_of "$prefix/nameless")" = application/x-sline ] || fail "a scene is not known by its bytes"
}

# Prints the long options that --help lists, without dashes; those of a group of options are
# indented further.
long_options() { # command...
  "$sline" "$@" --help | sed -n 's/^ \{2,4\}\(-[^ ]*\).*/\1/p' | tr ',' '\n' |
    sed -n 's/^--\([a-z0-9-]*\).*/\1/p'
}

page_is_sound() { # page
  local said
  said=$(LC_ALL=C.UTF-8 man --warnings -l "$1" 2>&1 >/dev/null
    groff -ww -z -man -Kutf8 "$1" 2>&1
    mandoc -T lint -W warning "$1" 2>&1 | grep -v 'missing date' || true)
  [ -z "$said" ] || fail "$1: $said"
}

manual() { # command
  local pages=$share/man/man1 option text zsh
  page_is_sound "$pages/sline-$1.1"
  grep -q "sline\\\\-$1 (1)" "$pages/sline.1" || fail "the page of sline does not name $1"
  text=$(MANWIDTH=500 LC_ALL=C.UTF-8 man -P cat -l "$pages/sline-$1.1" | sed 's/.\x08//g')
  zsh=$(sed -n "/^    $1)/,/^      ;;/p" "$share/zsh/site-functions/_sline")
  for option in $(long_options "$1"); do
    grep -qE -- "^ +(-., )?(--[a-z-]+, )*--$option([ ,]|\$)" <<<"$text" || fail "the page of $1 lacks --$option"
    grep -q "^    '$1') options='.*--$option[ ']" "$share/bash-completion/completions/sline" ||
      fail "bash: $1 lacks --$option"
    grep -q "__fish_seen_subcommand_from $1' .*-l $option " \
      "$share/fish/vendor_completions.d/sline.fish" || fail "fish: $1 lacks --$option"
    grep -qF -- "--$option[" <<<"$zsh" || fail "zsh: $1 lacks --$option"
  done
}

completed() { # word...: what bash offers for the last of them
  bash -c 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _sline; echo "${COMPREPLY[*]}"' \
    "$share/bash-completion/completions/sline" "$@"
}

completions() {
  bash -n "$share/bash-completion/completions/sline"
  zsh -n "$share/zsh/site-functions/_sline"
  fish -n "$share/fish/vendor_completions.d/sline.fish"
  [ "$(completed sline re)" = "render reload" ] || fail "bash: commands"
  [ "$(completed sline render --frame L)" = "LPS LAS" ] || fail "bash: words of an option"
  [ "$(completed sline render --frame = R)" = "RAS RPS" ] || fail "bash: --option=value"
  [ "$(completed sline render --context-f)" = --context-from ] || fail "bash: options"
  [ "$(cd "$prefix" && completed sline render --camera t.s)" = t.stl ] || fail "bash: files"
  [ "$(cd "$prefix" && completed sline proof --out b)" = bin ] || fail "bash: folders"
  local offered
  offered=$(fish --no-config -c "source $share/fish/vendor_completions.d/sline.fish
    complete -C 'sline demo --sex '" | cut -f 1 | sort | tr '\n' ' ')
  [ "$offered" = "female male " ] || fail "fish: words of an option: $offered"
}

layout
pictures
desktop
mime_type
page_is_sound "$share/man/man1/sline.1"
commands=$("$sline" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 14 ] || fail "--help lists too few commands"
for command in $commands; do
  manual "$command"
done
[ "$(ls "$share/man/man1" | wc -l)" -eq $(($(wc -w <<<"$commands") + 1)) ] || fail "a page too many"
completions
