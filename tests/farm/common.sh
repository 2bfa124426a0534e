# For the tests of docs/farm.md: what they share.
skip() { echo "SKIP: $*"; exit 77; }

# The commands that docs/farm.md shows under a name.
block() { awk -v name="$1" '$0 == "```bash " name { on = 1; next } /^```/ { on = 0 } on' "$source/docs/farm.md"; }

# ready FOLDER: where the commands are run; the whole sweep by one process is in its folder "whole".
ready() {
  cd "$1"
  ln -s "$source/scenes" scenes
  export PATH="$(dirname "$snell"):$PATH"
  mkdir out
  block gather >gather.sh
  began=$(date +%s%N)
  bash gather.sh
  echo "one process: $(seconds) s"
  mv out whole
  mkdir out
}

seconds() { awk "BEGIN { printf \"%.1f\", ($(date +%s%N) - $began) / 1e9 }"; }

# Complete, identical, nothing unfinished; gathering draws nothing.
same() {
  [ "$(ls whole | wc -l)" = 32 ] || fail "the sweep has $(ls whole | wc -l) pictures, not 32"
  diff -r whole out || fail "the pictures are not those of the unsharded sweep"
  bash gather.sh
  [ "$(grep -c '"skipped": true' all.json)" = 32 ] || fail "gathering drew pictures again"
  echo "32 pictures, identical to those of one process"
}
