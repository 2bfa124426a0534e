#!/usr/bin/env bash
# Runs the tests under what looks for mistakes that pictures do not show: all of them under the address and
# undefined-behaviour sanitizers (asan), those without OpenGL under valgrind, those with threads under the thread
# sanitizer (tsan). A finding fails. Times and memory are several times the usual ones.
# quick: of asan, what reads texts and files of others, without OpenGL; `.ci/run` has it.
# usage: run.sh [asan] [valgrind] [tsan] [quick]     from the repository's root; nothing named: the first three
set -uo pipefail
jobs=$(nproc)
failed=()
say() { printf '%s\n' "$*" >&2; }
# A scene that misses a file looks into the folders beside its own: temporary ones are of this run alone.
TMPDIR=$(mktemp -d) && chmod 711 "$TMPDIR" && export TMPDIR && trap 'rm -rf "$TMPDIR"' EXIT

build() {
  cmake --preset "$1" >&2 && cmake --build "build/$1" -- --quiet "${@:2}" >&2
}

# Reports of programs that tests start, too, whatever becomes of their streams.
findings() {
  if compgen -G "build/$1/findings/*" >/dev/null; then
    cat "build/$1"/findings/* >&2
    failed+=("$1: build/$1/findings")
  fi
}

# executables WHAT BUILD COMMAND...: under the command, the tests of each line of the standard input: a name, and perhaps
# a filter. As many at a time as there are cores.
executables() {
  export -f one
  xargs -P "$jobs" -L 1 bash -c 'one "$@"' one "$1" "$2" "${*:3}" || failed+=("$1: tests")
}
one() {
  local what=$1 build=$2 command=$3 name=$4 log="build/$2/$1-$4.log" begin=$SECONDS
  if $command "build/$build/bin/${name}_tests" --gtest_brief=1 ${5:+--gtest_filter="$5"} >"$log" 2>&1; then
    printf '%s %s: %s s, %s\n' "$what" "$name" $((SECONDS - begin)) "$(grep -o '[0-9]* tests* from .* ran' "$log" | tail -1)"
  else
    cat "$log"
    return 1
  fi
}

# The preset has intercept_tls_get_addr=0: up to GCC 13 the sanitizer takes a module's thread-local block that begins 16
# bytes after a page's begin for one of an old glibc, and its search for leaks reads what is before it and crashes, once
# in some hundred runs.
asan() {
  build asan || { failed+=("asan: the build"); return; }
  rm -rf build/asan/findings
  mkdir -p build/asan/findings
  ctest --preset asan -j "$jobs" --no-tests=error || failed+=("asan: tests")
  findings asan
}

# One test of the server's limits the memory, which the sanitizer needs more of.
quick() {
  local tests="parser translator plan lint language mesh image"
  cmake --preset asan >&2 && cmake --build build/asan --target snell snell_oiio \
    $(printf '%s_tests ' $tests) -- --quiet >&2 || { failed+=("quick: the build"); return; }
  rm -rf build/asan/findings
  mkdir -p build/asan/findings
  ctest --preset asan -j "$jobs" --no-tests=error \
    -R "^(${tests// /|})_tests(_[0-9]+)?$|^server_" -E '^server_protocol$' || failed+=("quick: tests")
  findings asan
}

# By name, and what is left out: arithmetic that goes on for minutes, what the fuzzers do under asan, and what valgrind
# can't do: telling of programs that can't be started, and copying the test's own file.
valgrind_tests() {
  cat <<'END'
parser -Total.RandomPieces:Total.HugeStatementsAndDeepNesting
translator
plan
lint
mesh -MeshTree.FindsWhatTryingAllFinds:MeshTree.IsBuiltQuickly
image -CubeLight.ReductionKeepsTheLight:Irradiance.*:Prefilter.*:Environments.KeepTheirLight:ImageNoise.LatticePoints*:ImageNoise.Resolution*:ImageNoise.HasTheAmplitudes*:ImageFormats.TheModuleIsFoundInstalled*
app -Editor.SaysWhatWentWrong:Process.AProgramIsFoundAsAShell*
ui
accuracy -Front.TwoRunsThatAreDecidedAgree
stability
optics -MeshPath.*
END
}
memcheck() {
  build release $(valgrind_tests | sed 's/ .*//; s/$/_tests/') || { failed+=("valgrind: the build"); return; }
  export SNELL_PATIENCE=200
  valgrind_tests | executables valgrind release valgrind -q --error-exitcode=66 --num-callers=24 --leak-check=full \
    --show-leak-kinds=definite --errors-for-leak-kinds=definite --suppressions=tests/sanitize/valgrind.supp
}

thread_tests="plan image app"
threads() {
  local tests=$thread_tests
  build tsan $(printf '%s_tests ' $tests) || { failed+=("tsan: the build"); return; }
  rm -rf build/tsan/findings
  mkdir -p build/tsan/findings
  export TSAN_OPTIONS="exitcode=66:second_deadlock_stack=1:suppressions=$PWD/tests/sanitize/threads.supp:log_path=$PWD/build/tsan/findings/report"
  # Its memory has fixed places, which some kernels give to others.
  printf '%s\n' $tests | executables tsan tsan setarch -R
  findings tsan
}

[ $# -gt 0 ] || set -- asan valgrind tsan
for part in "$@"; do
  case $part in
    asan) asan ;;
    valgrind) memcheck ;;
    tsan) threads ;;
    quick) quick ;;
    *) say "usage: tests/sanitize/run.sh [asan] [valgrind] [tsan] [quick]"; exit 2 ;;
  esac
done
if [ ${#failed[@]} -gt 0 ]; then
  printf 'failed: %s\n' "${failed[@]}" >&2
  exit 1
fi
