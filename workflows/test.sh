#!/usr/bin/env bash
# Installs missing packages, builds octacut and runs its tests.
#   workflows/test.sh [--fast 1] [--sanitize 1] [options of ctest]
# --fast 1         leave out the slow tests, which tests/slow_tests.txt lists
# --sanitize 1     build in build-asan with the address and undefined behaviour
#                  sanitizers (the preset asan-ubsan)
# Options of ctest are, for example, -R core_grid.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
arguments=()
leave_out=
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --fast)
      if ((${2:?"$1 needs 0 or 1"})); then
        leave_out=$(grep -v '^#' "$root/tests/slow_tests.txt" | paste -sd :)
        arguments+=(-LE slow)
      fi
      shift 2
      ;;
    --sanitize)
      if ((${2:?"$1 needs 0 or 1"})); then
        export OCTACUT_PRESET=asan-ubsan
        export OCTACUT_BUILD_DIR=${OCTACUT_BUILD_DIR:-$root/build-asan}
      fi
      shift 2
      ;;
    *)
      arguments+=("$1")
      shift
      ;;
  esac
done
build=${OCTACUT_BUILD_DIR:-$root/build}

"$root/workflows/setup.sh"
"$root/workflows/build.sh"
begin=$SECONDS
if OCTACUT_LEAVE_OUT=$leave_out ctest --test-dir "$build" -j2 --output-on-failure --no-tests=error \
  "${arguments[@]}"; then
  echo "test.sh: all tests passed in $((SECONDS - begin)) s"
  skipped=$(sed -n '/: Skipped$/{n;p}' "$build/Testing/Temporary/LastTest.log" |
    sort | uniq -c)
  if [[ -n $skipped ]]; then
    printf 'test.sh: skipped, by reason:\n%s\n' "$skipped"
  fi
else
  echo "test.sh: TESTS FAILED" >&2
  exit 1
fi
