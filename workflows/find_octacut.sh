#!/usr/bin/env bash
# Prints the path of the octacut executable: $OCTACUT when set, else that of
# the source tree, built if it is not there yet, else the installed one.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
built=${OCTACUT_BUILD_DIR:-$root/build}/bin/octacut

if [[ -n ${OCTACUT:-} ]]; then
  command -v "$OCTACUT" || {
    echo "OCTACUT=$OCTACUT cannot be run" >&2
    exit 1
  }
elif [[ -x $built ]]; then
  echo "$built"
elif command -v octacut; then
  :
else
  "$root/workflows/setup.sh" >&2
  "$root/workflows/build.sh" octacut >&2
  echo "$built"
fi
