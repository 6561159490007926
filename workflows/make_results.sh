#!/usr/bin/env bash
# Reconstructs the bundled example and every known data set of DATA_FOLDER,
# measures the meshes and writes docs/results.md.
#
#   workflows/make_results.sh [DATA_FOLDER] [options]
#
# DATA_FOLDER           default: $OCTACUT_SHARED_DATA, else ../shared/data
#                       beside the source tree; only read
# --target_level 9      meshes are cut from (2^level)^3 voxels; so is the hull, from
#                       1024^3 at most
# --only SCENE,...      run these alone; the others keep the figures of an
#                       earlier run, where those are up to date
# --work_path DIR       meshes, reports and logs; default build/results
# --results_path FILE   default docs/results.md
# --num_threads 2
# --redo 1              also what is up to date: made after the executable
#
# Exits with 1 when a scene failed; what has worked is written all the same.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source-path=SCRIPTDIR source=measuring.sh
source "$root/workflows/measuring.sh"

# name, folder, model, ground truth, whether the mesh is aligned to that first
# (the mapper's cameras agree with the exact ones only nearly).
scenes=(
  "example       -      sparse/0  gt/reference.ply 0"
  "temple        temple sparse/0  -                0"
  "dino          dino   sparse/0  -                0"
  "bunny         bunny  sparse/0  -                0"
  "igea-exact    igea   sparse_gt gt/mesh.ply      0"
  "igea-mapper   igea   sparse/0  gt/mesh.ply      1"
  "rocker-exact  rocker sparse_gt gt/mesh.ply      0"
  "rocker-mapper rocker sparse/0  gt/mesh.ply      1"
)

fail() {
  echo "make_results: $*" >&2
  exit 1
}

data=${OCTACUT_SHARED_DATA:-$root/../shared/data}
work=${OCTACUT_BUILD_DIR:-$root/build}/results
results=$root/docs/results.md
level=9
threads=2
redo=0
only=
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --target_level) level=${2:?"$1 needs a value"} ;;
    --only) only=${2:?"$1 needs a value"} ;;
    --work_path) work=${2:?"$1 needs a value"} ;;
    --results_path) results=${2:?"$1 needs a value"} ;;
    --num_threads) threads=${2:?"$1 needs a value"} ;;
    --redo) redo=${2:?"$1 needs 0 or 1"} ;;
    -*) fail "$1: no such option; --help lists them" ;;
    *)
      data=$1
      shift
      continue
      ;;
  esac
  shift 2
done
[[ $level =~ ^[2-9]$|^1[0-2]$ ]] ||
  fail "target_level = $level: must be 2 to 12"
[[ $threads =~ ^[1-9][0-9]*$ ]] ||
  fail "num_threads = $threads: must be at least 1"
[[ $redo == [01] ]] || fail "redo = $redo: must be 0 or 1"

unknown=$(unknown_of "$only" "${scenes[@]%% *}")
[[ -z $unknown ]] ||
  fail "only = $unknown: no such scene; there are ${scenes[*]%% *}"

command -v jq >/dev/null || "$root/workflows/setup.sh"
octacut=$("$root/workflows/find_octacut.sh")
mkdir -p "$work/level_$level" "$(dirname "$results")"
work=$(cd "$work" && pwd)
# The executable's time at the start: a build may replace it meanwhile.
stamp=$work/executable
touch -r "$octacut" "$stamp"
[[ -d $data ]] && data=$(cd "$data" && pwd)

# The commands below are run under `if`, where set -e does not hold.

make_example() {
  [[ ${example_done:-0} == 1 ]] && return 0
  if [[ $redo == 1 ]] || ! fresh "$work/example/example.json" ||
    ! jq -e .complete "$work/example/example.json" >/dev/null; then
    step "$work" example example_creator --output_path "$work/example" \
      --overwrite 1 || return 1
  fi
  example_done=1
}

# mesh FOLDER NAME WORKSPACE MODEL COMMAND OPTION...: FOLDER/NAME.ply.
mesh() {
  local folder=$1 name=$2 workspace=$3 model=$4
  local sources=("$workspace/images" "$workspace/masks" "$workspace/$model")
  shift 4
  if [[ $redo == 0 && -f $folder/$name.ply ]] &&
    fresh "$folder/$name.json" "${sources[@]}"; then
    return 0
  fi
  rm -f "$folder/$name.json" "$folder/$name.ply" "$folder/comparison.json"
  step "$folder" "$name" "$1" --workspace_path "$workspace" \
    --input_path "$workspace/$model" --output_path "$folder/$name.ply" "${@:2}"
}

# compare FOLDER TRUTH ALIGN. Without ground truth (-) the hull is held against
# the mesh, which counts the self-intersections of both.
compare() {
  local folder=$1 truth=$2 align=$3
  local inputs=(--input_path "$folder/hull.ply")
  if [[ $truth == - ]]; then
    truth=$folder/mesh.ply
  else
    inputs=(--input_path "$folder/mesh.ply" "${inputs[@]}")
  fi
  if [[ $redo == 0 ]] && fresh "$folder/comparison.json" \
    "$folder/mesh.json" "$folder/hull.json" "$truth"; then
    return 0
  fi
  rm -f "$folder/comparison.json"
  step "$folder" comparison mesh_comparer "${inputs[@]}" \
    --reference_path "$truth" --align "$align" \
    --output_path "$folder/comparison.json"
}

# reconstruct FOLDER WORKSPACE MODEL TRUTH ALIGN
reconstruct() {
  local folder=$1 workspace=$2 model=$3 truth=$4 align=$5
  local first_level=$((level < 7 ? level : 7))
  local hull_level=$((level < 10 ? level : 10)) # the hull's mesher ends there
  if [[ $workspace == "$work/example" ]]; then
    make_example || return 1
  fi
  [[ $truth == - ]] || truth=$workspace/$truth
  mesh "$folder" hull "$workspace" "$model" visual_hull_mesher \
    --OctahedralMeshing.hull_level "$hull_level" &&
    mesh "$folder" mesh "$workspace" "$model" octahedral_mesher \
      --OctahedralMeshing.hull_level "$first_level" \
      --OctahedralMeshing.target_level "$level" &&
    compare "$folder" "$truth" "$align"
}

# up_to_date FOLDER: all of an earlier run's reports can still be used.
up_to_date() {
  fresh "$1/mesh.json" && fresh "$1/hull.json" &&
    fresh "$1/comparison.json" "$1/mesh.json" "$1/hull.json"
}

# record STATE MESSAGE NAME MODEL TRUTH ALIGN: one line of JSON, for the tables.
# Paths of this machine are no figures.
record() {
  local folder=$work/level_$level/$3 part
  local message=${2//"$work"/WORK}
  message=${message//"$data"/DATA_FOLDER}
  local options=(--arg state "$1" --arg message "$message"
    --arg name "$3" --arg model "$4" --arg truth "$5" --argjson align "$6")
  for part in mesh hull comparison; do
    if [[ $1 != left_out ]] && fresh "$folder/$part.json"; then
      options+=(--slurpfile "$part" "$folder/$part.json")
    else
      options+=(--argjson "$part" "[]")
    fi
  done
  # shellcheck disable=SC2016 # variables of jq
  jq -nc "${options[@]}" '{name: $name, model: $model, state: $state,
    message: $message, truth: ($truth != "-"), aligned: ($align == 1),
    mesh: $mesh[0], hull: $hull[0], comparison: $comparison[0]}'
}

trap 'exit 130' INT
failed=0
records=$work/level_$level/scenes.jsonl
: >"$records"
for scene in "${scenes[@]}"; do
  read -r name dataset model truth align <<<"$scene"
  folder=$work/level_$level/$name
  workspace=$data/$dataset
  [[ $dataset == - ]] && workspace=$work/example
  state="done"
  error=
  if ! is_among "$name" "$only"; then
    if ! up_to_date "$folder"; then
      state=left_out
      error="not run: not among --only"
    fi
  elif [[ $dataset != - && ! -d $workspace/$model ]]; then
    state=left_out
    error="skipped: $workspace/$model is missing"
    echo "== $name: $error"
  else
    echo "== $name"
    mkdir -p "$folder"
    if ! reconstruct "$folder" "$workspace" "$model" "$truth" "$align"; then
      state=failed
      failed=1
      echo "make_results: $name: $error" >&2
    fi
  fi
  record "$state" "$error" "$name" "$model" "$truth" "$align" >>"$records"
done

jq -L "$root/workflows" -rs --arg machine "$(machine)" --argjson level "$level" \
  --argjson threads "$threads" -f "$root/workflows/results_tables.jq" \
  "$records" >"$results.part"
mv "$results.part" "$results"
echo
echo "written: $results"
if [[ $octacut -nt $stamp ]]; then
  fail "$octacut was replaced meanwhile: the figures are of both; run again"
fi
exit "$failed"
