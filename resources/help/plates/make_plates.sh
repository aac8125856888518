#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws the pictures of plates.md anew, from scenes that ship with the program:
#   make_plates.sh SLINE [ANATOMY]
# SLINE is the built program. ANATOMY is a folder with anatomy that others publish (plates.md says
# where), as files, folders or links; what is missing there is not drawn anew:
#   trachea.glb bronchus.glb heart.glb pelvis
#                                 Human Reference Atlas: trachea, main bronchi, heart, folder of a
#                                 male pelvis
#   abdomen                       abdominal atlas: folder with its scene, as atlas.mrml, and meshes
#   bodyparts liver_vessels       BodyParts3D: folders of a pelvis and of a liver with its vessels
#   labels.nii.gz                 labels of a CT by TotalSegmentator, with labels_names.tsv
#   kinase.pdb                    entry 2SRC of the Protein Data Bank
set -euo pipefail

sline=$(realpath "${1:?usage: make_plates.sh SLINE [ANATOMY]}")
anatomy=$(realpath "${2:-/nonexistent}")
cd "$(dirname "$0")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Small files: no alpha, strongest compression.
keep() { # FROM TO
  oiiotool "$1" --ch R,G,B --attrib "png:compressionLevel" 9 -o "$2"
}

plate() { # NAME SCENE FLAGS...
  local name=$1
  shift
  "$sline" demo "$@" -o "$scratch/$name.png"
  keep "$scratch/$name.png" "$name.png"
}

row() { # NAME SCENE STRUCTURE VIEW: gamma 0 to 5 side by side
  local cells=()
  for gamma in 0 1 2 3 4 5; do
    cells+=("$scratch/$1_$gamma.png")
    "$sline" demo "$2" --only "$3" --view "$4" --gamma "$gamma" --size 220x220 -o "${cells[-1]}"
  done
  oiiotool "${cells[@]}" --mosaic 6x1 -o "$scratch/$1.png"
  keep "$scratch/$1.png" "$1.png"
}

vessels=(--gamma Arteries=3 --gamma Veins=3 --ink-colour Arteries=#a81c14 --ink-colour Veins=#1f468f)

# Abdomen as the program opens with it: what is in focus shaded, vessels hatched, the rest contours.
plate abdomen_front abdomen --view Overview --size 900x900
plate abdomen_left abdomen --view left --size 900x900 --gamma "descending colon=4.3"
plate abdomen_back abdomen --view "From behind" --size 900x900

# Pelvis: first as the program opens with it.
plate pelvis pelvis --size 1000x800
pelvis=(--size 1000x800)
plate pelvis_front pelvis --view Overview "${pelvis[@]}"
plate pelvis_back pelvis --view posterior "${pelvis[@]}" --gamma Nerves=4.5
# The left wall of the pelvis is taken away beside the sacrum, organs and vessels stay whole.
plate pelvis_left pelvis --view left --size 900x900 --section sagittal=32:right \
  --section-group Bones --section-group Muscles --section-group Nerves

# Half pelves
plate half_pelvis_male pelvis --sex male --view Midsagittal --size 900x900
plate half_pelvis_female pelvis --view Midsagittal --size 900x900

# Lines as measured and as drawn
"$sline" demo pelvis --gamma 2 --fill paper --size 700x700 -o "$scratch/measured.png" \
  --line-smoothing 0 --line-variation 0 --shortest-line 0 --line-scale 0
"$sline" demo pelvis --gamma 2 --fill paper --size 700x700 -o "$scratch/drawn.png"
oiiotool "$scratch/measured.png" "$scratch/drawn.png" --mosaic 2x1 -o "$scratch/lines.png"
keep "$scratch/lines.png" lines.png
plate hidden_lines abdomen --gamma 2 --fill paper --gamma Arteries=3 --size 900x900 \
  --hidden-lines Arteries=dashed --halo Arteries=1

# Print, cut
plate print pelvis --bw --view Midsagittal --size 1000x1000
plate abdomen_axial abdomen --view "Transpyloric plane" --size 1100x800

# Drawing styles, side by side.
cells=()
for style in plate even-pen textbook woodcut pencil operating-note lecture-hall; do
  cells+=("$scratch/style_$style.png")
  "$sline" demo abdomen --view Overview --drawing "$style" --size 180x210 -o "${cells[-1]}"
done
oiiotool "${cells[@]}" --mosaic 7x1 -o "$scratch/drawing_styles.png"
keep "$scratch/drawing_styles.png" drawing_styles.png

row gamma_liver abdomen liver anterior
row gamma_kidney kidney "left kidney" anterior
row gamma_stomach abdomen stomach anterior
row gamma_hip_bone pelvis "left hip bone" left

if [ -e "$anatomy/trachea.glb" ]; then
  # Strokes alone let the cartilages behind the wall show as on tracing paper.
  "$sline" render "$anatomy/trachea.glb" -o "$scratch/trachea_3.png" --camera trachea_camera.json \
    --size 800x800 --gamma 3 --fill veil
  "$sline" render "$anatomy/trachea.glb" -o "$scratch/trachea_4.5.png" --camera trachea_camera.json \
    --size 800x800 --gamma 4.5
  for gamma in 3 4.5; do
    keep "$scratch/trachea_$gamma.png" "trachea_gamma_$gamma.png"
  done
fi

if [ -e "$anatomy/bodyparts" ]; then
  cells=()
  for technique in sline confis apparent_ridges ridges photic laplacian demarcating highlights; do
    cells+=("$scratch/technique_$technique.png")
    "$sline" render "$anatomy/bodyparts" --look plain --only "right hip bone" --view right \
      --gamma 2.5 --technique "$technique" --size 300x300 -o "${cells[-1]}"
  done
  oiiotool "${cells[@]}" --mosaic 4x2 -o "$scratch/techniques.png"
  keep "$scratch/techniques.png" techniques.png
fi

confis() { # NAME FLAGS...: one of three side by side
  local name=$1
  shift
  "$sline" render "$@" -o "$scratch/confis_$name.png" --look plain --gamma 3 --technique confis \
    --size 400x400
}
if [ -e "$anatomy/trachea.glb" ] && [ -e "$anatomy/bronchus.glb" ] && [ -e "$anatomy/bodyparts" ]; then
  confis trachea "$anatomy/trachea.glb" --camera trachea_camera.json --fill veil
  confis bronchi "$anatomy/bronchus.glb" --view anterior --fill paper
  confis hip "$anatomy/bodyparts" --only "right hip bone" --view right --fill paper
  oiiotool "$scratch/confis_trachea.png" "$scratch/confis_bronchi.png" "$scratch/confis_hip.png" \
    --mosaic 3x1 -o "$scratch/confis.png"
  keep "$scratch/confis.png" confis.png
fi
if [ -e "$anatomy/liver_vessels" ]; then
  "$sline" render "$anatomy/liver_vessels" -o "$scratch/confis_vessels.png" --look plain \
    --only Veins --only "Portal system" --view anterior --gamma 3 --technique confis --fill paper \
    --ink-colour Veins=#1f468f --size 700x560
  keep "$scratch/confis_vessels.png" confis_vessels.png
fi

liver=$(find -L "$anatomy" -path '*abdomen*' -name '*_liver.vtk' 2>/dev/null | head -n 1 || true)
hip=$(find -L "$anatomy" -path '*bodyparts*' -name '*right_hip_bone.obj' 2>/dev/null | head -n 1 || true)
if [ -n "$liver" ] && [ -n "$hip" ] && [ -e "$anatomy/kinase.pdb" ]; then
  "$sline" compare "$liver" "$hip" "$anatomy/kinase.pdb" --view anterior --dpi 110 \
    -o "$scratch/comparison.png"
  keep "$scratch/comparison.png" comparison.png
  "$sline" compare "$liver" --noise staircase --noise jitter --smooth off --view anterior --dpi 110 \
    -o "$scratch/comparison_rough.png"
  keep "$scratch/comparison_rough.png" comparison_rough.png
fi

if [ -e "$anatomy/kinase.pdb" ]; then
  "$sline" render "$anatomy/kinase.pdb" --look plain --gamma 1.5 --gamma-by occlusion \
    --size 900x700 -o "$scratch/gamma_by_occlusion.png"
  keep "$scratch/gamma_by_occlusion.png" gamma_by_occlusion.png
fi

opening() { # NAME INPUT: plain and as it opens, side by side
  [ -e "$anatomy/$2" ] || return 0
  "$sline" render "$anatomy/$2" --look plain --size 560x560 -o "$scratch/$1_plain.png"
  "$sline" render "$anatomy/$2" --size 560x560 -o "$scratch/$1_plate.png"
  oiiotool "$scratch/$1_plain.png" "$scratch/$1_plate.png" --mosaic 2x1 -o "$scratch/$1.png"
  keep "$scratch/$1.png" "opening_$1.png"
}
opening abdomen abdomen/atlas.mrml
opening labels labels.nii.gz
opening bodyparts bodyparts
opening pelvis pelvis
opening heart heart.glb
opening kinase kinase.pdb
