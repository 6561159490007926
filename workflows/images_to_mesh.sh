#!/usr/bin/env bash
# From photographs to a mesh: COLMAP's features, matches and mapper, then octacut's
# masks, mesh and picture. No masks are needed, neither a display nor CUDA.
#
#   workflows/images_to_mesh.sh IMAGES WORKSPACE [options]
#
# IMAGES                 folder of the photographs, which stays as it is
# WORKSPACE              folder for all results; created where missing. Its
#                        folder images becomes a link to IMAGES unless it exists.
#                        A database or sparse model of your own in it is refused
# --turntable 1          the camera stood still and the object turned: what does
#                        not turn is masked before COLMAP sees it
# --background_path F    photographs of the empty set, for --turntable 1
# --on_stand -1|0|1      leave out the plane on which the object stands: if there
#                        is one, never, always. Default: -1, with --turntable 1
#                        it is 1
# --single_camera 0|1    one camera with one zoom took all photographs; default 1
# --max_num_features N   of each photograph; default 8192, as COLMAP has it
# --reference_path M     sparse model of the same photographs into whose frame
#                        COLMAP's model is moved; default none
# All other options are passed to `octacut octahedral_mesher`.
#
# Run again, it skips the steps that are finished. A changed option or changed
# photographs redo the steps that depend on them. Masks in WORKSPACE/masks that
# were changed by hand are kept and used.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
workflows=$root/workflows
if [[ $# -lt 2 || $1 == -* || $2 == -* ]]; then
  sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
  [[ ${1:-} == -h || ${1:-} == --help ]] && exit 0
  exit 1
fi
images=${1%/}
workspace=${2%/}
shift 2
turntable=0
background=
on_stand=
single_camera=1
features=8192
reference=
meshing=()
while (($#)); do
  case $1 in
    --turntable) turntable=${2:?"$1 needs 0 or 1"} && shift 2 ;;
    --background_path) background=${2:?"$1 needs a value"} && shift 2 ;;
    --on_stand) on_stand=${2:?"$1 needs -1, 0 or 1"} && shift 2 ;;
    --single_camera) single_camera=${2:?"$1 needs 0 or 1"} && shift 2 ;;
    --max_num_features) features=${2:?"$1 needs a value"} && shift 2 ;;
    --reference_path) reference=${2:?"$1 needs a value"} && shift 2 ;;
    *) meshing+=("$1") && shift ;;
  esac
done

fail() {
  echo "images_to_mesh: $1" >&2
  exit 1
}
[[ -d $images ]] || fail "$images: there is no such folder of photographs"
[[ $turntable == [01] ]] || fail "--turntable $turntable: must be 0 or 1"
on_stand=${on_stand:-$((2 * turntable - 1))}
[[ $on_stand =~ ^(-1|0|1)$ ]] || fail "--on_stand $on_stand: must be -1, 0 or 1"
[[ $single_camera == [01] ]] || fail "--single_camera $single_camera: must be 0 or 1"
[[ $features =~ ^[1-9][0-9]*$ ]] ||
  fail "--max_num_features $features: must be a positive number"
[[ -z $background || $turntable == 1 ]] ||
  fail "--background_path $background: is for --turntable 1"
command -v colmap >/dev/null ||
  fail "COLMAP is not installed (package colmap in Debian)"
octacut=$("$workflows/find_octacut.sh")

export QT_QPA_PLATFORM=offscreen
done_marks=$workspace/steps
# These are replaced below.
for result in database.db sparse mapped; do
  [[ -d $done_marks || ! -e $workspace/$result ]] ||
    fail "$workspace/$result: was not made by this script; choose another WORKSPACE"
  [[ -z $reference || $(realpath -m "$reference")/ != "$(realpath -m "$workspace/$result")/"* ]] ||
    fail "--reference_path $reference: must not lie in $workspace/$result, which is replaced"
done
mkdir -p "$done_marks"
log=$workspace/images_to_mesh.log

# The names, sizes and times of all files in folders.
files_of() {
  find -L "$@" -type f -printf '%P %s %T@\n' | sort
}

# step NAME KEY OUTPUT COMMAND...: runs the command unless it has finished with
# the same key and its output is there. Steps that follow have the key of this
# one in theirs, and run too if this one does.
redo=0
step() {
  local name=$1 output=$3 sum
  sum=$(sha256sum <<<"$previous $2" | cut -c1-32)
  previous=$sum
  if [[ $redo == 0 && -e $output &&
    $(cat "$done_marks/$name" 2>/dev/null) == "$sum" ]]; then
    echo "== $name: finished already"
    return
  fi
  echo "== $name"
  redo=1
  rm -f "$done_marks/$name"
  "${@:4}" || exit 1
  [[ -e $output ]] || fail "$name has not made $output; see $log"
  echo "$sum" >"$done_marks/$name"
}

# COLMAP's messages are many; they go to the log.
run_colmap() {
  colmap "$@" >>"$log" 2>&1 || fail "colmap $1 failed; see $log"
}

turning_masks() {
  local options=()
  [[ -z $background ]] || options=(--background_path "$background")
  "$octacut" mask_extractor --mode turntable --image_path "$images" \
    --output_path "$workspace/turning_masks" "${options[@]}"
}

# Photographs without a sure mask of what turns would bring the background back.
extract_features() {
  rm -f "$workspace"/database.db*
  local options=()
  if [[ $turntable == 1 ]]; then
    jq -r '.views[] | select(.status != "unsure") | .image' \
      "$workspace/turning_masks/masks.json" >"$workspace/steps/images.txt"
    [[ -s $workspace/steps/images.txt ]] ||
      fail "no photograph has a sure mask of what turns; $workspace/turning_masks/masks.json says why"
    options=(--ImageReader.mask_path "$workspace/turning_masks"
      --image_list_path "$workspace/steps/images.txt")
  fi
  run_colmap feature_extractor --database_path "$workspace/database.db" \
    --image_path "$images" --ImageReader.single_camera "$single_camera" \
    --"$extraction".use_gpu 0 --SiftExtraction.max_num_features "$features" \
    "${options[@]}"
}

match() {
  run_colmap exhaustive_matcher --database_path "$workspace/database.db" \
    --"$matching".use_gpu 0
}

map() {
  rm -rf "$workspace/sparse" "$workspace/mapped"
  mkdir -p "$workspace/mapped"
  run_colmap mapper --database_path "$workspace/database.db" \
    --image_path "$images" --output_path "$workspace/mapped"
  local model
  model=$(largest_model "$workspace/mapped")
  [[ -n $model ]] || fail "the mapper found no model; see $log"
  if [[ -n $reference ]]; then
    "$workflows/align_model.sh" "$reference" "$model" "$workspace/sparse/0" "$log"
  else
    cp -r "$workspace/mapped" "$workspace/sparse"
  fi
}

extract_masks() {
  local options=(--on_stand "$on_stand")
  [[ $turntable == 0 ]] || options+=(--strokes_path "$workspace/turning_masks")
  "$octacut" mask_extractor --workspace_path "$workspace" \
    --image_path "$images" "${options[@]}"
}

mesh() {
  "$octacut" octahedral_mesher --workspace_path "$workspace" \
    --image_path "$images" "${meshing[@]}"
}

# shellcheck source-path=SCRIPTDIR source=colmap_options.sh
source "$workflows/colmap_options.sh"
# Where other commands look for the photographs of the workspace.
[[ -e $workspace/images || -L $workspace/images ]] ||
  ln -s "$(cd "$images" && pwd)" "$workspace/images"

previous=$(cd "$images" && pwd -P)
previous+=$(files_of "$images")
if [[ $turntable == 1 ]]; then
  key=turntable
  [[ -z $background ]] || key+=$(files_of "$background")
  step turning_masks "$key" "$workspace/turning_masks/masks.json" turning_masks
fi
step features "$turntable $single_camera $features" "$workspace/database.db" \
  extract_features
step matches "" "$workspace/database.db" match
step mapper "$reference" "$workspace/sparse" map
step masks "$on_stand" "$workspace/masks/masks.json" extract_masks
result=$("$workflows/option_value.sh" --output_path \
  "$workspace/meshed-octahedral.ply" "${meshing[@]}")
step mesh "$(files_of "$workspace/masks") ${meshing[*]}" "$result" mesh
echo "masks:  $workspace/masks (look at contact_sheet.jpg)"
echo "mesh:   $result"
[[ ! -f ${result%.*}.png ]] || echo "picture: ${result%.*}.png"
