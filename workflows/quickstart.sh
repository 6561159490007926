#!/usr/bin/env bash
# From a fresh clone on Debian 12 to a mesh: installs what is missing, builds,
# makes the bundled example, reconstructs it and compares the result with the
# example's reference mesh.
#
#   workflows/quickstart.sh [WORKSPACE] [--with_colmap 1] [options]
#
# WORKSPACE          where the example goes; default build/example
# --with_colmap 1    COLMAP finds the cameras from the photographs itself
#                    (some minutes)
# Other options go to `octacut octahedral_mesher`.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

workspace=${OCTACUT_BUILD_DIR:-$root/build}/example
with_colmap=0
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
    *)
      options+=("$1")
      shift
      ;;
  esac
done

"$root/workflows/setup.sh"
"$root/workflows/build.sh" octacut
octacut=$("$root/workflows/find_octacut.sh")

echo
echo "== The example: photographs, masks and a sparse model"
if grep -q '"complete": true' "$workspace/example.json" 2>/dev/null; then
  echo "$workspace is there already"
else
  "$octacut" example_creator --output_path "$workspace" --overwrite 1
fi

reference=$workspace/gt/reference.ply
result=$workspace
if [[ $with_colmap == 1 ]]; then
  echo
  echo "== COLMAP finds the cameras"
  result=$workspace/colmap
  "$root/workflows/run_colmap.sh" "$workspace" "$result"
fi

echo
echo "== octacut octahedral_mesher"
"$octacut" octahedral_mesher --workspace_path "$result" \
  --mask_path "$workspace/masks" --image_path "$workspace/images" \
  "${options[@]}"

echo
echo "== Comparison with the reference"
"$octacut" mesh_comparer --input_path "$result/meshed-octahedral.ply" \
  --reference_path "$reference" \
  --output_path "$result/meshed-octahedral-comparison.json"

echo
echo "mesh:       $result/meshed-octahedral.ply"
echo "report:     $result/meshed-octahedral.json"
for picture in "$result"/meshed-octahedral*.png; do
  [[ -f $picture ]] && echo "picture:    $picture"
done
echo "comparison: $result/meshed-octahedral-comparison.json"
echo "reference:  $reference"
