#!/usr/bin/env bash
# From a fresh clone on Debian 12 to a mesh: installs missing packages, builds
# octacut, creates the bundled example, reconstructs it and compares the result
# with the example's reference mesh.
#
#   workflows/quickstart.sh [WORKSPACE] [--with_colmap 1 [--with_masks 0]] [options]
#
# WORKSPACE          folder of the example; default build/example
# --with_colmap 1    let COLMAP estimate the cameras from the photographs, which
#                    takes some minutes
# --with_masks 0     for --with_colmap 1: everything from photographs alone, of the
#                    example on a stand in a room; no given mask enters any step.
#                    WORKSPACE is build/example-without-masks then
# All other options are passed to `octacut octahedral_mesher`.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

workspace=
with_colmap=0
with_masks=1
options=()
if [[ $# -gt 0 && $1 != -* ]]; then
  workspace=$1
  shift
fi
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --with_colmap)
      with_colmap=${2:?"--with_colmap needs 0 or 1"}
      shift 2
      ;;
    --with_masks)
      with_masks=${2:?"--with_masks needs 0 or 1"}
      shift 2
      ;;
    *)
      options+=("$1")
      shift
      ;;
  esac
done

if [[ $with_masks == 0 && $with_colmap != 1 ]]; then
  echo "quickstart: --with_masks 0 needs --with_colmap 1" >&2
  exit 1
fi
scene=()
name=example
if [[ $with_masks == 0 ]]; then
  # Cameras below the stand would not see the object.
  scene=(--Scene.stand 1 --Scene.background room --Rig.min_elevation 8)
  name=example-without-masks
fi
workspace=${workspace:-${OCTACUT_BUILD_DIR:-$root/build}/$name}

"$root/workflows/setup.sh"
"$root/workflows/build.sh" octacut
octacut=$("$root/workflows/find_octacut.sh")

echo
echo "== Creating the example: photographs, masks and a sparse model"
made_with=$workspace/quickstart_options.txt
if ! grep -q '"complete": true' "$workspace/example.json" 2>/dev/null; then
  "$octacut" example_creator --output_path "$workspace" --overwrite 1 "${scene[@]}"
  echo "${scene[*]}" >"$made_with"
elif [[ $(cat "$made_with" 2>/dev/null) == "${scene[*]}" ]]; then
  echo "$workspace exists already"
else
  # Results of the other example would mix with those of this one.
  echo "quickstart: $workspace holds an example that was made with other options;" \
    "name another folder or delete it" >&2
  exit 1
fi

reference=$workspace/gt/reference.ply
result=$workspace
if [[ $with_masks == 0 ]]; then
  result=$workspace/from_photographs
elif [[ $with_colmap == 1 ]]; then
  echo
  echo "== Estimating the cameras with COLMAP"
  result=$workspace/colmap
  "$root/workflows/run_colmap.sh" "$workspace" "$result"
  # Photographs and masks stay where they are, unless the user says otherwise.
  for part in image mask; do
    folder=$("$root/workflows/option_value.sh" "--${part}_path" "" "${options[@]}")
    if [[ -z $folder ]]; then
      options+=("--${part}_path" "$workspace/${part}s")
    fi
  done
fi
mesh=$("$root/workflows/option_value.sh" --output_path \
  "$result/meshed-octahedral.ply" "${options[@]}")
report=$("$root/workflows/option_value.sh" --report_path \
  "${mesh%.*}.json" "${options[@]}")
comparison=${mesh%.*}-comparison.json

echo
echo "== Reconstructing the mesh"
if [[ $with_masks == 0 ]]; then
  # The example's cameras say only in which frame the mesh is to be compared.
  # Matching the 8192 features that COLMAP takes by default needs too long here.
  "$root/workflows/images_to_mesh.sh" "$workspace/images" "$result" --on_stand 1 \
    --max_num_features 2000 --reference_path "$workspace/sparse/0" "${options[@]}"
else
  "$octacut" octahedral_mesher --workspace_path "$result" "${options[@]}"
fi

echo
echo "== Comparing the mesh with the reference"
"$octacut" mesh_comparer --input_path "$mesh" \
  --reference_path "$reference" --output_path "$comparison"

echo
echo "mesh:       $mesh"
echo "report:     $report"
if [[ -f ${mesh%.*}.png ]]; then
  echo "picture:    ${mesh%.*}.png"
fi
echo "comparison: $comparison"
echo "reference:  $reference"
