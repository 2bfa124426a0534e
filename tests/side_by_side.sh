#!/usr/bin/env bash
# Runs the tests of an executable as N processes at once: tests of windows wait most of the time.
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
status=0
for i in "${!pids[@]}"; do
  wait "${pids[i]}" || status=1
  cat "$logs/$i"
done
exit $status
