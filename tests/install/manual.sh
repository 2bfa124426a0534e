#!/usr/bin/env bash
# manual.sh BUILD ROOT: the manual pages are free of errors, and completions work in bash, and in zsh and fish if they
# are installed.
set -euo pipefail
build=$(realpath "$1") root=$(realpath "$2") manual=$(realpath "$1")/manual
export PATH=$build/bin:$PATH
cd "$root"
scene=scenes/refraction-room/refraction-room.glib
fail() {
  echo "$*" >&2
  exit 1
}

# A page for every subcommand, and each option of it.
for name in $(sed -n "s/^_snell_commands='\(.*\)'/\1/p" "$manual/bash/snell"); do
  [ -f "$manual/man1/snell-$name.1" ] || fail "snell-$name(1) is missing"
  for option in $(snell "$name" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
    grep -qF -- "${option//-/\\-}" "$manual/man1/snell-$name.1" || fail "snell-$name(1) lacks $option"
  done
done
if man -l "$manual/man1/snell.1" >/dev/null 2>&1; then
  for page in "$manual"/man1/*.1; do
    told=$(LC_ALL=C.UTF-8 man -l --warnings "$page" 2>&1 >/dev/null)
    [ -z "$told" ] || fail "$page: $told"
  done
  LC_ALL=C.UTF-8 man -l "$manual/man1/snell-new.1" | grep -qE '^ +displace  waves.* waves\)$' || fail "lists in notes are filled"
else
  echo "man is not installed: the pages are not read"
fi
if command -v mandoc >/dev/null; then mandoc -T lint -W warning "$manual"/man1/*.1; fi

# complete WORD...: what bash offers for the last word, where words are split as bash splits them.
complete_bash() {
  bash --norc -c '
    source "$1"; shift
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMP_LINE="$*"
    _snell
    printf "%s\n" "${COMPREPLY[@]}"' bash "$manual/bash/snell" "$@"
}
# offers WANTED WORD...: WANTED is among them.
offers() {
  local wanted=$1
  shift
  complete_bash "$@" | grep -qxF -- "$wanted" || fail "bash does not offer '$wanted' for: $* but: $(complete_bash "$@" | head -5)"
}
offers_not() {
  local wanted=$1
  shift
  ! complete_bash "$@" | grep -qxF -- "$wanted" || fail "bash offers '$wanted' for: $*"
}
offers render snell re
offers --output snell render --ou
offers_not --output snell check --ou
offers uIndex= snell render $scene --set uI
offers_not uIndex= snell render $scene --set uX
offers uIndex= snell render "'$scene'" --set uI
offers BEND=single snell scenes/light/glass/glass.glib --ladder BE
offers uIndex= snell render $scene --set = uI
offers single snell render scenes/light/glass/glass.glib --ladder BEND = si
offers BEND=single snell render scenes/light/glass/glass.glib --ladder BEN
offers BEND snell accuracy scenes/light/glass/glass.glib --ladders BE
offers BEND= snell sweep scenes/light/glass/glass.glib --over BE
offers balanced snell render $scene --quality b
offers always snell check --color a
offers statements= snell check --limit state
offers scenes/environments snell render --confine scenes/e
offers $scene snell render scenes/refraction-room/
offers $scene snell check --grade scenes/refraction-room/
offers_not scenes/refraction-room/glass.vert snell render scenes/refraction-room/
offers Sphere snell commands Sph
offers glsl-syntax snell help glsl-s
offers render snell help ren
offers render snell --color never rend
offers render snell --color = never rend
offers_not render snell --color never render re
offers --output snell --color never render --ou
offers RATIO,BEND snell accuracy scenes/light/glass/glass.glib --ladders RATIO,BE
offers_not BEND,BEND snell accuracy scenes/light/glass/glass.glib --ladders BEND,BE
# What a scene is called, and what it names, is quoted and never run.
odd=$(mktemp -d)
trap 'rm -rf "$odd"' EXIT
printf 'Perspective 60\nVertex a\nFragment a\nProgram B ux`touch$IFS%s/run`y 3 uGood 4 uA[2] 5\nSphere 1\n' "$odd" >"$odd/it's.glib"
[ -z "$(snell complete uniforms "$odd/it's.glib" 'ux')" ] || fail "a name that GLSL cannot have is offered"
offers uGood= snell render "$odd/it\\'s.glib" --set uG
offers uGood= snell render "\"$odd/it's.glib\"" --set uG
offers 'uA\[2\]=' snell render "$odd/it\\'s.glib" --set uA
[ ! -e "$odd/run" ] || fail "a completion ran a name of the scene"
[ -z "$(complete_bash snell render $scene --size 8)" ] || fail "bash offers sizes"

# With a real Tab on a terminal.
tab() {
  python3 tests/install/tab.py "$shell" "$manual" "$@" &
  running+=($!)
}
for shell in bash zsh fish; do
  if ! command -v "$shell" >/dev/null; then
    echo "$shell is not installed: its completion is not tried"
    continue
  fi
  running=()
  tab "snell render $scene --set uI" "uIndex="
  tab "snell render scenes/light/glass/glass.glib --ladder BEND=si" "BEND=single"
  tab "snell ren" "render "
  tab "snell --color never ren" "render "
  tab "snell accuracy scenes/light/glass/glass.glib --ladders RATIO,BEN" "RATIO,BEND"
  tab "snell check --js" "--json "
  tab "snell render scenes/refraction-room/ref" "refraction-room.glib"
  for one in "${running[@]}"; do wait "$one"; done  # they mostly wait for the shell
done
