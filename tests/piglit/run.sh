#!/usr/bin/env bash
# run.sh BIN FOLDER: piglit's shaders, fetched into FOLDER, through snell_piglit of BIN. The Debian package is unpacked,
# not installed: its 2 GB are programs for the most part, and 68 MB are shaders.
set -euo pipefail
bin=$1 folder=$2
here=$(cd "$(dirname "$0")" && pwd)
if [ ! -d "$folder/tests" ]; then
  mkdir -p "$folder"
  cd "$folder"
  if ! apt-get download -qq piglit 2>/dev/null; then
    if [ "$(id -u)" = 0 ]; then apt-get update -qq; else sudo apt-get update -qq; fi
    apt-get download -qq piglit
  fi
  dpkg-deb --fsys-tarfile piglit_*.deb | tar -x --strip-components=5 --wildcards \
    '*/piglit/*.vert' '*/piglit/*.frag' '*/piglit/*.geom' '*/piglit/*.tesc' '*/piglit/*.tese'
  rm piglit_*.deb
  cd - >/dev/null
fi
exec "$bin/snell_piglit" "$folder" "$here/exceptions.txt" "$folder/report.txt"
