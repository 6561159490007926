#!/usr/bin/env bash
# Measures the cut engine against Boost and OpenCV on synthetic crusts and on
# stored ones, and writes docs/experiments/cut_engine_tables.md.
#
#   workflows/benchmark_cut.sh [options] [INSTANCE.oct...]
#
# --max_resolution 2048 of the synthetic crusts: 128 to 2048. From 1024 on the
#                       engine runs alone; the peers need up to 3 GB
# --peers 1             0: the engine alone
# --threads 1           also the engine on 2 threads, by the wall's clock:
#                       0 on a machine that has other work
# --work_path DIR       what was measured; default build/cut
# --results_path FILE   default docs/experiments/cut_engine_tables.md
# --measure 1           0: only write the tables of what was measured before
#
# Instances of a real reconstruction up to 512^3 (16 bytes a voxel) are written by
#   OCTACUT_BUILD_DIR=build workflows/build.sh octacut_crust_writer
#   build/tests/bench/octacut_crust_writer --workspace_path W \
#       --output_path build/cut/NAME [--input_path MODEL] [--target_level 9]
# and measured with the rest by
#   workflows/benchmark_cut.sh build/cut/NAME/*.oct
# The last cut of every level is compared with the peers, and all cuts of a
# crust that grew are solved from nothing and from the state of the one before.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${OCTACUT_BUILD_DIR:-$root/build}
work=$build/cut
results=$root/docs/experiments/cut_engine_tables.md
max_resolution=2048
peers=1
threads=1
measure=1
instances=()
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --max_resolution) max_resolution=${2:?"$1 needs a value"} ;;
    --peers) peers=${2:?"$1 needs 0 or 1"} ;;
    --threads) threads=${2:?"$1 needs 0 or 1"} ;;
    --work_path) work=${2:?"$1 needs a value"} ;;
    --results_path) results=${2:?"$1 needs a value"} ;;
    --measure) measure=${2:?"$1 needs 0 or 1"} ;;
    -*)
      echo "benchmark_cut: $1: no such option; --help lists them" >&2
      exit 1
      ;;
    *)
      instances+=("$1")
      shift
      continue
      ;;
  esac
  shift 2
done
mkdir -p "$work"
runs=$work/runs.jsonl

# run_kind KIND RESOLUTION SOLVER...
run_kind() {
  local kind=$1 resolution=$2 repetitions=1
  shift 2
  # Whatever else happens in a tenth of a second shows in a single run.
  ((resolution <= 128)) && repetitions=5
  if ((resolution <= max_resolution)); then
    echo "$kind $resolution: $*" >&2
    "$bench" --kind "$kind" --resolution "$resolution" --solvers "$@" \
      --repetitions $repetitions >>"$runs"
  fi
}

describe_machine() {
  printf '%s, %s cores, load average %s\n' \
    "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" "$(nproc)" \
    "$1" >"$work/machine.txt"
}

# measure_crust INSTANCE...: the cuts of one crust
measure_crust() {
  echo "${*: -1}" >&2
  {
    "$bench" --instance "${@: -1}" --solvers octacut tasks "${linked[@]:0:1}"
    "$bench" --instance "${@: -1}" --lean 1
    "$bench" --growing "$@"
  } >>"$runs"
}

# Those of one crust are FOLDER/level_LL_1.oct, FOLDER/level_LL_2.oct, ...
measure_instances() {
  local instance crust='' cuts=()
  while read -r instance; do
    if [[ ${instance%_*} != "$crust" && ${#cuts[@]} -gt 0 ]]; then
      measure_crust "${cuts[@]}"
      cuts=()
    fi
    crust=${instance%_*}
    cuts+=("$instance")
  done < <(printf '%s\n' "${instances[@]}" | sort -V)
  measure_crust "${cuts[@]}"
}

measure_all() {
  local resolution kind linked=()
  ((peers)) && linked=(boost opencv)
  for resolution in 128 256 512; do
    run_kind shell $resolution octacut tasks "${linked[@]}"
    run_kind hard $resolution octacut tasks "${linked[@]}"
  done
  # A filled hull has as many voxels as a crust of twice the resolution.
  for resolution in 64 128 256; do
    ((2 * resolution <= max_resolution)) || continue
    run_kind level0 $resolution octacut tasks "${linked[@]}"
    run_kind evidence $resolution octacut tasks "${linked[@]}"
  done
  # Threads and lean flows at the largest of these.
  for kind in shell hard level0 evidence; do
    resolution=$((max_resolution < 512 ? max_resolution : 512))
    [[ $kind == level0 || $kind == evidence ]] && resolution=$((resolution / 2))
    "$bench" --kind $kind --resolution $resolution --lean 1 >>"$runs"
    if ((threads)); then
      "$bench" --kind $kind --resolution $resolution --repetitions 2 >>"$runs"
      "$bench" --kind $kind --resolution $resolution --num_threads 2 \
        --repetitions 3 >>"$runs"
    fi
  done
  if ((${#instances[@]})); then
    measure_instances
  fi
  run_kind shell 1024 octacut
  run_kind hard 1024 octacut
  ((max_resolution >= 1024)) && run_kind level0 512 octacut
  run_kind shell 2048 octacut
}

if ((measure)); then
  "$root/workflows/build.sh" octacut_cut_bench >&2
  bench=$build/tests/bench/octacut_cut_bench
  : >"$runs"
  before=$(cut -d' ' -f1 /proc/loadavg)
  describe_machine "$before"
  measure_all
  describe_machine "$before to $(cut -d' ' -f1 /proc/loadavg)"
fi
jq -L "$root/workflows" -rs --arg machine "$(cat "$work/machine.txt")" \
  -f "$root/workflows/cut_tables.jq" "$runs" >"$work/results.md"
mv "$work/results.md" "$results"
echo "$results" >&2
