#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# package_test.sh: makes the packages, lets lintian judge the one for Debian, and runs the programs
# from the archive, unpacked into an empty folder, with the libraries that it brings along.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "package_test.sh: $*" >&2
  exit 1
}

mapfile -t packages < <("$top/app/package.sh" | tail -n 2)
debian=${packages[0]}
archive=${packages[1]}

lintian --fail-on error --allow-root "$debian"
for field in Depends Recommends Maintainer Section; do
  [ -n "$(dpkg-deb -f "$debian" "$field")" ] || fail "the package does not say $field"
done
dpkg-deb -x "$debian" "$folder/debian"
for program in sline sline-workstation; do
  [ -x "$folder/debian/usr/bin/$program" ] || fail "the package lacks $program"
  [ -z "$(patchelf --print-rpath "$folder/debian/usr/bin/$program")" ] || fail "$program looks elsewhere"
done
apt-get install --simulate "$debian" >/dev/null || fail "what the package depends on is not to be had"

[ -s "$folder/debian/usr/lib/sline/libsline-pixels.so" ] || fail "the package lacks its part for pictures"

tar -C "$folder" -xzf "$archive"
cd "$folder"/sline-*
unset LD_LIBRARY_PATH QT_PLUGIN_PATH QT_QPA_PLATFORM
export HOME=$folder XDG_CACHE_HOME=$folder/cache XDG_CONFIG_HOME=$folder/config
export XDG_STATE_HOME=$folder/state XDG_RUNTIME_DIR=$folder/runtime
mkdir -m 700 "$XDG_RUNTIME_DIR"
bin/sline --version
bin/sline demo kidney -o k.png
[ "$(head -c 4 k.png | tail -c 3)" = PNG ] || fail "no picture was drawn"
bin/sline demo kidney -o k.tiff
[ "$(head -c 2 k.tiff)" = II ] || fail "no TIFF was written"
! ldd bin/sline bin/sline-workstation lib/sline/libsline-pixels.so | grep 'not found' || fail "a library is absent"

# The running window may have loaded Qt and VTK from here alone.
xvfb-run -a bash -c '
  bin/sline-workstation --demo kidney &
  window=$!
  for ((second = 0; second < 60; ++second)); do
    sleep 1
    kill -0 $window || exit 1
    grep -q libqxcb-glx "/proc/$window/maps" && break
  done
  sleep 3
  kill -0 $window || exit 1
  cat "/proc/$window/maps" >loaded
  kill $window' || fail "the window does not open"
grep -q 'lib/sline/plugins/platforms/libqxcb.so' loaded || fail "the window did not use its plugins"
! grep -E '/lib(Qt6|vtk|tbb|q)[^/]*$' loaded | grep -v "$PWD/lib/sline/" || fail "libraries from outside"
for package in $(ls share/doc/sline/libraries); do
  [ -s "share/doc/sline/libraries/$package" ] || fail "$package has an empty notice"
done
echo "Passed: $(du -h "$debian" | cut -f 1) and $(du -h "$archive" | cut -f 1)."
