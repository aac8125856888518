#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs what building and testing needs from Debian 12's own packages; does nothing where all is
# there. Works as root or through sudo.
set -euo pipefail

packages=(
  # compiler, build, checks
  build-essential cmake ninja-build ccache git pkg-config clang clang-format clang-tidy
  libclang-rt-14-dev
  # Qt, a display for its tests; meshes and volumes, pixel files
  qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
  libqt6opengl6-dev libgl-dev libglx-mesa0 fonts-dejavu-core fonts-dejavu-extra xvfb
  xauth libx11-dev
  libvtk9-dev libglew-dev
  libopenexr-dev libjpeg62-turbo-dev
  # other programs' opinion of our pictures, vector drawings and sheets
  libopenimageio-dev openimageio-tools libopencv-dev
  librsvg2-bin
  inkscape
  poppler-utils
  # OpenGL without a display
  libepoxy-dev libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri
  # small libraries
  libtbb-dev libglm-dev nlohmann-json3-dev libcli11-dev libpugixml-dev libzip-dev
  zlib1g-dev libbz2-dev
  # films; ffmpeg is a program that writes some where it is installed
  libwebp-dev libgif-dev ffmpeg
  # Anki's packages
  libsqlite3-dev
)

# For Khronos's glTF validator; whoever has npm from elsewhere keeps it.
command -v npm >/dev/null || packages+=(nodejs npm)

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$state" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || {
    echo "Missing packages: ${missing[*]}. Install them as root, or install sudo." >&2
    exit 1
  }
  as_root=(sudo)
fi
echo "Installing ${#missing[@]} packages: ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq >&2
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
