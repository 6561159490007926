#!/usr/bin/env bash
# benchmark_masks.sh DATA [options]
#
# Extracts masks for data sets that have masks, measures the extracted ones
# against those, and reconstructs a mesh with each. DATA holds a folder for each
# set with images, masks and a sparse model, and gt/mesh.ply where there is a
# true surface (with exact cameras in sparse_gt). Meshes are compared with it over
# what three cameras see within 75 degrees of its normal, and as a whole. The set
# `example` is created. The tables of docs/masks.md go to the standard output.
# Nothing is written to DATA.
#
#   --sets LIST           comma-separated; default: all that are in DATA, and the
#                         example
#   --work_path FOLDER    for masks, meshes and reports, default build/masks
#   --target_level N      of the meshes, default 8; 0 makes none
#   --num_threads N       default 1
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$root/build/masks
threads=1
level=8
sets=
data=
while (($#)); do
  case $1 in
    --help | -h)
      sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --sets) sets=${2:?"$1 needs a value"} && shift 2 ;;
    --work_path) work=${2:?"$1 needs a value"} && shift 2 ;;
    --target_level) level=${2:?"$1 needs a value"} && shift 2 ;;
    --num_threads) threads=${2:?"$1 needs a value"} && shift 2 ;;
    -*)
      echo "benchmark_masks: $1: no such option; --help lists them" >&2
      exit 1
      ;;
    *) data=$1 && shift ;;
  esac
done
if [[ -z $data || ! -d $data ]]; then
  echo "benchmark_masks: the folder DATA is needed; --help says more" >&2
  exit 1
fi
octacut=$("$root/workflows/find_octacut.sh")
mkdir -p "$work"

# run NAME COMMAND OPTION...: messages into NAME.log, CPU seconds into NAME.cpu.
run() {
  local name=$1 TIMEFORMAT=%U
  shift
  { time "$octacut" "$@" --num_threads "$threads" \
    >"$work/$name.log" 2>&1; } 2>"$work/$name.cpu" && return 0
  echo "benchmark_masks: $name: $(tail -n 1 "$work/$name.log")" >&2
  return 1
}

# The sets that have what is needed, with the model to use.
model_of() {
  local model
  for model in "$1/sparse" "$1/sparse_gt"; do
    [[ -d $model ]] && echo "$model" && return
  done
}

if [[ -z $sets ]]; then
  sets=example
  for folder in "$data"/*/; do
    [[ -d $folder/images && -d $folder/masks ]] && sets+=,$(basename "$folder")
  done
fi

masks_row() {
  local name=$1 report=$work/$1-masks.json
  jq -r --arg name "$name" --arg cpu "$(cat "$work/$name-extract.cpu")" '
    def round2: . * 100 | round / 100;
    [$name, (.masks | length), .missing, (100 * .mean.overlap | round2),
     (.mean.border_mean | round2), (.mean.border_percentile_95 | round2),
     ($cpu | tonumber | round)] | "| " + (map(tostring) | join(" | ")) + " |"
  ' "$report"
}

extract() {
  local name=$1 path=$2
  run "$name-extract" mask_extractor --workspace_path "$path" \
    --input_path "$(model_of "$path")" --output_path "$work/$name" &&
    run "$name-compare" mask_comparer --mask_path "$work/$name" \
      --reference_path "$path/masks" --output_path "$work/$name-masks.json"
}

# mesh NAME PATH KIND MASKS
mesh() {
  run "$1-$3" octahedral_mesher --workspace_path "$2" \
    --input_path "$(model_of "$2")" --mask_path "$4" --picture 0 \
    --OctahedralMeshing.target_level "$level" --output_path "$work/$1-$3.ply"
}

# compare NAME TRUTH REPORT OPTION...: of the mesh NAME with the TRUTH.
compare() {
  run "$1-$3" mesh_comparer --input_path "$work/$1.ply" --reference_path "$2" \
    --align 1 --self_intersections 0 "${@:4}" --output_path "$work/$1-$3.json"
}

mesh_row() {
  local name=$1 path=$2 kind truth cameras=$2/sparse_gt
  [[ -d $cameras ]] || cameras=$(model_of "$path")
  for truth in "$path/gt/mesh.ply" "$path/gt/reference.ply"; do
    [[ -f $truth ]] && break
  done
  for kind in given extracted; do
    if [[ -f $truth ]]; then
      compare "$name-$kind" "$truth" seen --views_path "$cameras" || return 1
      compare "$name-$kind" "$truth" whole || return 1
    fi
    run "$name-$kind-views" mesh_evaluator --workspace_path "$path" \
      --input_path "$(model_of "$path")" --mesh_path "$work/$name-$kind.ply" \
      --self_intersections 0 --output_path "$work/$name-$kind-views.json" ||
      return 1
    row "$name" "$kind"
  done
}

row() {
  local part reports=("$work/$1-$2-views.json")
  for part in seen whole; do
    [[ ! -f $work/$1-$2-$part.json ]] || reports+=("$work/$1-$2-$part.json")
  done
  jq -rs --arg name "$1, $2" '
    def rounded: . * 1000 | round / 1000;
    def errors: (.meshes[0].comparison // null) |
      if . == null then "" else
      "\(100 * .to_reference.mean_over_diagonal | rounded) / \(
        100 * .from_reference.mean_over_diagonal | rounded)" end;
    .[0].meshes[0] as $views |
    [$name, (.[1] | errors), (.[2] | errors),
     (100 * $views.silhouettes.intersection_over_union | rounded),
     ($views.reprojection.mean_correlation * 10000 | round / 10000)]
    | "| " + (map(tostring) | join(" | ")) + " |"
  ' "${reports[@]}"
}

path_of() {
  if [[ $1 == example ]]; then
    echo "$work/example-workspace"
  else
    echo "$data/$1"
  fi
}

if [[ ,$sets, == *,example,* && ! -d $work/example-workspace ]]; then
  run example-create example_creator --output_path "$work/example-workspace"
fi
echo "| set | views | left out | overlap, % | border: mean, pixels | 95 % | CPU s |"
echo "|---|---|---|---|---|---|---|"
for name in ${sets//,/ }; do
  if extract "$name" "$(path_of "$name")"; then
    masks_row "$name"
  else
    echo "| $name | failed | | | | | |"
  fi
done
((level > 0)) || exit 0
echo
echo "| set, masks | what is seen: to / from the truth, % | whole surface | overlap, % | NCC |"
echo "|---|---|---|---|---|"
for name in ${sets//,/ }; do
  path=$(path_of "$name")
  [[ -d $work/$name ]] || continue
  if mesh "$name" "$path" given "$path/masks" &&
    mesh "$name" "$path" extracted "$work/$name"; then
    mesh_row "$name" "$path" || true
  else
    echo "| $name | failed | | | |"
  fi
done
