#!/usr/bin/env bash
# Runs the tests of an executable as N processes at once: tests of windows wait most of the time. Those that fail are
# run once more, alone: a display or a process may have been late. What is wrong fails both times.
# usage: side_by_side.sh N COMMAND...
set -uo pipefail
shards=$1
shift
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
pids=()
for ((i = 0; i < shards; ++i)); do
  GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$i "$@" >"$logs/$i" 2>&1 &
  pids+=($!)
done
ended=0
for i in "${!pids[@]}"; do
  wait "${pids[i]}" || tail -n 5 "$logs/$i"
  grep -q '^\[==========\] .* ran' "$logs/$i" || ended=1  # a crash: the tests behind it were not run
done
# What failed, and no more: where the output is cut, it is cut behind this.
awk '/^\[ RUN /{t = ""} {t = t $0 "\n"} /^\[  FAILED  \] .* ms\)$/{printf "%s", t}' "$logs"/*
failed=$(sed -n 's/^\[  FAILED  \] \([A-Za-z0-9_]*\.[A-Za-z0-9_]*\) (.*/\1/p' "$logs"/* | paste -sd:)
[ "$ended" = 0 ] || exit 1
[ -n "$failed" ] || exit 0
echo "once more: $failed"
"$@" "--gtest_filter=$failed"
