#!/usr/bin/env bash
# Compares the octahedral graph with voxel-centre graphs of 6, 18 and 26
# neighbours and writes docs/experiments/octahedral_graph.md and its pictures.
#   workflows/compare_graphs.sh [FOLDER]     default: docs/experiments
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${OCTACUT_BUILD_DIR:-$root/build}
"$root/workflows/build.sh" octacut_graph_comparison >&2
"$build/tests/bench/octacut_graph_comparison" "${1:-$root/docs/experiments}"
