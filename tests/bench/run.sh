#!/usr/bin/env bash
# Runs all benchmarks in the repository's folder and writes what they found as JSON and as a page.
# usage: run.sh BIN OUT PAGE [quick]     quick: everything once, to see that it runs
set -euo pipefail
bin=$1 out=$2 page=$3 mode=${4:-}
mkdir -p "$out"
bench=(--benchmark_min_time=0.2 --benchmark_repetitions=3)
rounds=21
if [ "$mode" = quick ]; then
  # Of what grows, the beginning.
  bench=(--benchmark_min_time=0 '--benchmark_filter=^(process/a|translate|shapes|plan|first picture|noise/2D|images/write)|^frame.*, 512 x 512/|:/(1|100)/')
  rounds=1
fi
"$bin/snell_bench" "${bench[@]}" --benchmark_out="$out/benchmarks.json" --benchmark_out_format=json >"$out/benchmarks.txt"
status=0
"$bin/room_pairs" --rounds "$rounds" --json "$out/pairs.json" >"$out/pairs.txt" || status=$?
if [ "$status" = 77 ]; then
  cat "$out/pairs.txt"
  exit 77
fi
: >"$out/instructions.txt"
if [ "$mode" != quick ] && command -v valgrind >/dev/null; then
  for who in snell by-hand; do
    counted=$(valgrind --tool=callgrind --toggle-collect=snell_counted_frame --callgrind-out-file="$out/callgrind.$who" \
      "$bin/room_pairs" --count "$who" 2>&1 | sed -n 's/.*Collected : *//p')
    echo "$who $counted" >>"$out/instructions.txt"
  done
fi
slow=0
python3 -B tests/bench/lsp.py "$bin/snell" "$([ "$mode" = quick ] && echo 1 || echo 10)" >"$out/lsp.txt" || slow=$?
[ "$mode" = quick ] || [ "$status" != 0 ] || status=$slow
python3 tests/bench/report.py "$out" "$page"
# Above the limits: for who measures to know, not for who only tries whether it runs.
[ "$mode" = quick ] || exit "$status"
