#!/usr/bin/env bash
# Builds octacut in build/ (or $OCTACUT_BUILD_DIR), with ninja and ccache if they
# are installed, by the preset $OCTACUT_PRESET (default: release). Later runs
# build only what has changed.
#   workflows/build.sh [TARGET...]     without TARGET, everything is built
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${OCTACUT_BUILD_DIR:-$root/build}

options=(--preset "${OCTACUT_PRESET:-release}")
if command -v ccache >/dev/null; then
  # Without this setting, ccache keeps nothing that uses precompiled headers.
  options+=("-DCMAKE_CXX_COMPILER_LAUNCHER=env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache")
fi
# A build folder stays with the generator that made it.
if [[ ! -f $build/CMakeCache.txt ]] && command -v ninja >/dev/null; then
  options+=(-G Ninja)
fi
cmake -S "$root" -B "$build" "${options[@]}" >/dev/null

targets=()
if [[ $# -gt 0 ]]; then
  targets=(--target "$@")
fi
# A compiler may take 2 GB.
memory_gb=$(awk '/MemAvailable/ { print int($2 / 1048576) }' /proc/meminfo)
jobs=$(nproc)
if ((memory_gb / 2 < jobs)); then
  jobs=$((memory_gb / 2 > 0 ? memory_gb / 2 : 1))
fi
cmake --build "$build" -j "$jobs" "${targets[@]}"
