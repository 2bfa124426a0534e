#!/usr/bin/env bash
# run.sh BIN SECONDS NAME...   runs these fuzzers for SECONDS of processor time each, as many at once as there are
# cores, and prints the rows of the table in docs/reliability.md. What they find lies in build/fuzz/found/NAME.
# FUZZ_AT_ONCE: how many at once instead.
set -euo pipefail
bin=$1 seconds=$2
shift 2
here=$(dirname "${BASH_SOURCE[0]}")
out=build/fuzz/found
mkdir -p "$out"
ulimit -c 0

fuzz() {
  local name=$1 log=$out/$1.log folder=$out/$1 options=() inputs=("$here/$1_corpus")
  mkdir -p "$folder"
  [ -f "$here/$name.dict" ] && options+=("-dict=$here/$name.dict")
  case $name in
    parser) inputs+=(tests/odd tests/bad) ;;
    glsl) inputs+=(tests/glsl) ;;
    *) options+=(-max_len=4096) ;;
  esac
  # A minute of the clock for one input: the machine may have much else to do.
  "$bin/${name}_fuzz" "${options[@]}" -timeout=60 -report_slow_units=60 -print_final_stats=1 \
    -artifact_prefix="$folder/finding-" "$folder" "${inputs[@]}" >"$log" 2>&1 &
  local pid=$! code=0 spent=0 now
  # The processor's seconds, not the clock's: beside other work they are fewer.
  while ((spent < seconds)) && now=$(ps -o cputimes= -p $pid) && [ "$now" ]; do
    spent=$((now)) && sleep 1
  done
  kill -INT $pid 2>/dev/null || true
  wait $pid || code=$?
  local executions edges features memory found
  executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  memory=$(sed -n 's/^stat::peak_rss_mb: *//p' "$log")
  read -r edges features < <(sed -nE 's/^#.* cov: ([0-9]+) ft: ([0-9]+) .*/\1 \2/p' "$log" | tail -1)
  found=$(find "$folder" -name 'finding-*' | wc -l)
  echo "| \`${name}_fuzz\` | $spent | $executions | $edges | $features | $memory MB | $found |"
  ((found == 0))
}
export -f fuzz
export bin seconds here out
printf '%s\n' "$@" | xargs -P "${FUZZ_AT_ONCE:-$(nproc)}" -I{} bash -c 'fuzz "{}"'
