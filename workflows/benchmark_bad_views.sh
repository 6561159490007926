#!/usr/bin/env bash
# benchmark_bad_views.sh WORKSPACE MODEL FOREIGN_MASK... [options]
#
# Makes copies of a workspace in which one mask, two or a third are wrong, and
# writes down which of them visual_hull_mesher names. Of MODEL (a folder in the
# workspace) all images have masks <image name>.png of one size. FOREIGN_MASK is
# a mask of another object. Rows of the table go to the standard output.
#
#   --work_path FOLDER    for the copies, default build/bad_views
#   --name NAME           of the set in the table, default that of the folder
#   --num_threads N       default 1
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$root/build/bad_views
threads=1
name=
given=()
while (($#)); do
  case $1 in
    --help | -h)
      sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --work_path) work=${2:?"$1 needs a value"} && shift 2 ;;
    --name) name=${2:?"$1 needs a value"} && shift 2 ;;
    --num_threads) threads=${2:?"$1 needs a value"} && shift 2 ;;
    -*)
      echo "benchmark_bad_views: $1: no such option; --help lists them" >&2
      exit 1
      ;;
    *) given+=("$1") && shift ;;
  esac
done
if ((${#given[@]} < 3)); then
  echo "benchmark_bad_views: WORKSPACE MODEL FOREIGN_MASK are needed" >&2
  exit 1
fi
workspace=$(cd "${given[0]}" && pwd)
model=${given[1]}
foreign=${given[2]}
name=${name:-$(basename "$workspace")}
command -v convert >/dev/null || "$root/workflows/setup.sh" >&2
octacut=$("$root/workflows/find_octacut.sh")
mkdir -p "$work"
mapfile -t masks < <(find "$workspace/masks" -name '*.png' -printf '%P\n' | sort)
count=${#masks[@]}
read -r width height < <(identify -format '%w %h\n' "$workspace/masks/${masks[0]}")

# fault KIND MASK PARTNER COPY: the mask of the copy becomes wrong.
fault() {
  local kind=$1 from=$workspace/masks/$2 to=$4/masks/$2
  rm -f "$to"
  case $kind in
    shifted-*)
      convert "$from" -virtual-pixel Black -filter point -distort \
        ScaleRotateTranslate "0,0 1 0 $((width * ${kind#*-} / 100)),0" "$to"
      ;;
    mirrored) convert "$from" -flop "$to" ;;
    foreign) convert "$foreign" -resize "${width}x$height!" "$to" ;;
    # Poses that are exchanged are masks and photographs that are; the hull needs
    # masks alone.
    exchanged)
      rm -f "$4/masks/$3"
      cp "$workspace/masks/$3" "$to"
      cp "$from" "$4/masks/$3"
      ;;
  esac
}

# row KIND HOW_MANY: the views are far from each other.
row() {
  local kind=$1 many=$2 copy=$work/$name/$1-$2 i at partner wrong=()
  rm -rf "$copy"
  mkdir -p "$copy/masks"
  ln -s "$workspace"/masks/*.png "$copy/masks/"
  for ((i = 0; i < many; ++i)); do
    at=$(((count / 5 + i * count / many) % count))
    partner=$(((at + count / (3 * many) + 1) % count))
    fault "$kind" "${masks[at]}" "${masks[partner]}" "$copy"
    wrong+=("${masks[at]}")
    [[ $kind != exchanged ]] || wrong+=("${masks[partner]}")
  done
  local outcome="left out"
  "$octacut" visual_hull_mesher --workspace_path "$copy" \
    --input_path "$workspace/$model" --output_path "$copy/hull.ply" \
    --OctahedralMeshing.hull_level 5 --num_threads "$threads" --log_color 0 \
    >"$copy/hull.log" 2>&1 || outcome=refused
  # Only contradicting views are followed by both figures.
  local named found=0 mask
  if [[ $outcome == refused ]]; then
    named=$(grep -oE 'masks/[^ ]+ \([0-9.]+ %, [0-9.]+ %\)' "$copy/hull.log" |
      sed 's/^masks.//; s/ .*//' || true)
  else
    named=$(jq -r '.input.contradicting_views.views[].mask' "$copy/hull.json" |
      sed 's/.*masks.//')
  fi
  [[ -n $named ]] || outcome="not found"
  for mask in "${wrong[@]}"; do
    if grep -qxF "$mask" <<<"$named"; then found=$((found + 1)); fi
  done
  echo "| $name | $kind | ${#wrong[@]} of $count | $found |" \
    "$(($(grep -c . <<<"$named" || true) - found)) | $outcome |"
  rm -rf "$copy/masks"
}

for kind in shifted-5 shifted-33 mirrored exchanged foreign; do
  third=$((count / 3))
  [[ $kind != exchanged ]] || third=$((count / 6))
  row "$kind" 1
  [[ $kind == exchanged ]] || row "$kind" 2
  row "$kind" "$third"
done
