#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws the pictures of the guide anew, from scenes that ship with the program:
#   make_guide.sh SLINE
# SLINE is the built program.
set -euo pipefail

sline=$(realpath "${1:?usage: make_guide.sh SLINE}")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The program carries them: no alpha, few tones, strongest compression.
keep() { # FROM TO
  oiiotool "$1" --ch R,G,B --attrib "png:compressionLevel" 9 -o "$2"
}

draw() { # NAME SCENE FLAGS...
  local name=$1
  shift
  "$sline" demo "$@" -o "$scratch/$name.png"
}

picture() { # NAME SCENE FLAGS...
  draw "$@"
  keep "$scratch/$1.png" "$1.png"
}

row() { # NAME CELLS...: side by side
  local name=$1
  shift
  oiiotool "${@/#/$scratch/}" --mosaic "$#x1" -o "$scratch/$name.png"
  keep "$scratch/$name.png" "$name.png"
}

picture start abdomen --view Overview --size 480x400
picture focus pelvis --view Overview --size 480x380
picture sections pelvis --view Midsagittal --size 420x420

cells=()
for gamma in 0 1 2 3 4 5; do
  draw "gamma_$gamma" kidney --only "left kidney" --view anterior --gamma "$gamma" --size 110x140
  cells+=("gamma_$gamma.png")
done
row gamma "${cells[@]}"

cells=()
for fill in none paper veil tint; do
  draw "fill_$fill" kidney --view anterior --gamma "left kidney=1.5" --fill "$fill" \
    --size 150x170
  cells+=("fill_$fill.png")
done
row fills "${cells[@]}"

cells=()
for view in anterior left superior; do
  draw "view_$view" kidney --view "$view" --size 180x180
  cells+=("view_$view.png")
done
row views "${cells[@]}"
