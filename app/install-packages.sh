#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# install-packages.sh [--tests | --package]: installs what building and running needs from Debian
# 12's own packages, with --tests what testing needs beyond it, with --package what app/package.sh
# needs; does nothing if all is there. Works as root or through sudo.
set -euo pipefail

packages=(
  # compiler and build
  build-essential cmake ninja-build pkg-config
  # the program of the students' page, and the bundler of its script
  emscripten esbuild
  # Qt and OpenGL, with a display and without one; the letters of labels
  qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
  libqt6opengl6-dev libgl-dev libglx-mesa0 libepoxy-dev libegl-dev libegl1 libegl-mesa0 libgl1-mesa-dri
  fonts-dejavu-core fonts-dejavu-extra
  # meshes and volumes, pixel files, films
  libvtk9-dev libopenmesh-dev libopenimageio-dev libwebp-dev libgif-dev
  # meshes of other programs, compressed glTF
  libassimp-dev libdraco-dev libmeshoptimizer-dev
  # PDF files, colours
  libqpdf-dev liblcms2-dev
  # small libraries
  libtbb-dev libglm-dev nlohmann-json3-dev libcli11-dev libpugixml-dev libzip-dev
  zlib1g-dev libbz2-dev libsqlite3-dev
  # DICOM
  libdcmtk-dev libopenjp2-7-dev
  # molecules: gemmi's headers, which need PEGTL's
  gemmi-dev tao-pegtl-dev
  # syllables of labels
  libhyphen-dev hyphen-de hyphen-nl hyphen-no hyphen-en-us hyphen-en-gb
)

# dpkg-shlibdeps finds programs with `file`; archives get their own search path by patchelf.
packaging=(dpkg-dev file patchelf)

testing=(
  "${packaging[@]}"
  # a display for the window's tests
  xvfb xauth x11-xserver-utils libx11-dev
  # checks, sanitizers and fuzzing; a compiler cache, as tests are built many times
  clang clang-format clang-tidy libclang-rt-14-dev ccache git
  # the renderer that sline-bench compares with
  libglew-dev
  # other programs that check our pictures, vector drawings, sheets and films
  openimageio-tools librsvg2-bin inkscape poppler-utils ffmpeg
  # programs that check what is installed, man pages and completions, and the Debian package
  lintian desktop-file-utils appstream shared-mime-info libglib2.0-bin libxml2-utils
  man-db groff mandoc zsh fish
  # a browser that opens the students' page
  chromium
)
# Khronos's glTF validator and the students' page's tests need npm; an npm installed from elsewhere is kept.
command -v npm >/dev/null || testing+=(nodejs npm)

case "${1:-}" in
  "") ;;
  --tests) packages+=("${testing[@]}") ;;
  --package) packages+=("${packaging[@]}") ;;
  *)
    echo "usage: app/install-packages.sh [--tests | --package]" >&2
    exit 2
    ;;
esac

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
