#!/usr/bin/env bash
# The sweep of docs/farm.md by GNU parallel.   usage: gnu_parallel.sh PROGRAM SOURCE_FOLDER     status 77: skipped
set -euo pipefail
snell=$(realpath "$1") source=$(realpath "$2")
. "$source/tests/farm/common.sh"
parallel --version 2>/dev/null | grep -q '^GNU parallel' || skip "GNU parallel is not installed (Debian: parallel)"
work=$(mktemp -d "${TMPDIR:-/tmp}/snell-parallel-XXXXXX")
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
export HOME=$work # where parallel keeps its notes

ready "$work"
began=$(date +%s%N)
block parallel >parallel.sh
bash parallel.sh
echo "four processes: $(seconds) s"
same
