#!/usr/bin/env bash
# Installs missing packages, builds octacut and runs all tests.
#   workflows/test.sh [options of ctest]     for example -R core_grid
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${OCTACUT_BUILD_DIR:-$root/build}
if [[ ${1:-} == -h || ${1:-} == --help ]]; then
  sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  exit 0
fi

"$root/workflows/setup.sh"
"$root/workflows/build.sh"
begin=$SECONDS
if ctest --test-dir "$build" -j2 --output-on-failure --no-tests=error "$@"; then
  echo "test.sh: all tests passed in $((SECONDS - begin)) s"
else
  echo "test.sh: TESTS FAILED" >&2
  exit 1
fi
