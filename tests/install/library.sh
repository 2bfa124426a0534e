#!/usr/bin/env bash
# library.sh BUILD ROOT: another program finds what is installed by find_package(snell), and draws what `snell render` draws.
set -euo pipefail
build=$(realpath "$1") root=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "$*" >&2
  exit 1
}
cmake --install "$build" --prefix "$work/first" >"$work/log" || fail "$(tail "$work/log")"
mv "$work/first" "$work/prefix"
[ "$(wc -l <"$root/examples/embed/main.cpp")" -le 60 ] || fail "the example has more than 60 lines"
cp -r "$work/prefix/share/doc/snell/examples/embed" "$work/embed"
generator=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$build/CMakeCache.txt")
cmake -S "$work/embed" -B "$work/build" -G "$generator" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_FLAGS=-Wall \
  >"$work/log" 2>&1 || fail "$(tail -20 "$work/log")"
cmake --build "$work/build" >"$work/log" 2>&1 || fail "$(tail -30 "$work/log")"
! grep -q warning: "$work/log" || fail "$(grep warning: "$work/log")"
cd "$work"
scene=$work/prefix/share/snell/scenes/refraction-room/refraction-room.glib
build/embed "$scene" own.ppm || fail "the example ends with $?"
prefix/bin/snell render "$scene" -o snell.png --size 320x240
if command -v compare >/dev/null; then
  compare -metric AE own.ppm snell.png null: 2>count || true
  [ "$(cut -d' ' -f1 count)" = 0 ] || fail "$(cat count) pixels differ from those of snell render"
fi
echo "find_package(snell) works"
