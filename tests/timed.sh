#!/usr/bin/env bash
# Runs tests that judge times. Those that fail are run once more, because another process may have taken the processor;
# what is wrong fails both times.
# usage: timed.sh COMMAND...
set -uo pipefail
log=$(mktemp)
trap 'rm -f "$log"' EXIT
"$@" 2>&1 | tee "$log"
[ "${PIPESTATUS[0]}" = 0 ] && exit 0
failed=$(sed -n 's/^\[  FAILED  \] \([A-Za-z0-9_]*\.[A-Za-z0-9_]*\) (.*/\1/p' "$log" | paste -sd:)
[ -n "$failed" ] || exit 1
echo "once more: $failed"
"$@" "--gtest_filter=$failed"
