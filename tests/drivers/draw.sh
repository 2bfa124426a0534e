#!/usr/bin/env bash
# Draws the scenes of scenes/ and tests/cases, each by a process of its own, with the driver that the environment chooses.
# usage: [SCENES="…"] [SIZE=100x100] [LIMIT=60] draw.sh PROGRAM OUT [CONTEXT]     from the repository's root
# OUT gets info.txt, and of each scene PATH.png, PATH.txt (messages) and PATH.status. Status 3: the driver does not start.
set -uo pipefail
snell=$(realpath "$1") out=$2
context=(${3:+--context "$3"})
mkdir -p "$out"
"$snell" info "${context[@]}" >"$out/info.txt" 2>&1 || exit 3
one() {
  local to=$out/${1%.glib}
  mkdir -p "$(dirname "$to")"
  "$snell" render "$1" -o "$to.png" --size "$size" --timeout "$limit" "${@:2}" >"$to.txt" 2>&1
  echo $? >"$to.status"
}
export -f one
export snell out size=${SIZE:-100x100} limit=${LIMIT:-60}
printf '%s\n' ${SCENES:-tests/cases/*.glib $(find scenes -name '*.glib')} |
  xargs -P "$(nproc)" -I{} bash -c 'one "$@"' one {} "${context[@]}"
