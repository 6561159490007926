#!/usr/bin/env bash
# Reconstructs a mesh after COLMAP's mapper, compares it with the dense meshes
# that COLMAP has left in the same workspace, and writes a page in which a person
# can look at them and at the photographs: WORKSPACE/compare-dense.html.
#
#   workflows/after_mapper.sh WORKSPACE [options of octacut octahedral_mesher]
#
# WORKSPACE holds images/, masks/ and sparse/; --image_path, --mask_path and
# --input_path select other folders. If the script is run again, it replaces its
# own results and changes nothing else. Give --output_path on the command line
# and not in a --project_path file, because the comparison reads it there.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 1 || $1 == -* ]]; then
  sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  [[ ${1:-} == -h || ${1:-} == --help ]] && exit 0
  exit 1
fi
workspace=${1%/}
shift

# The comparison has to know where the mesh goes.
mesh=$("$root/workflows/option_value.sh" --output_path \
  "$workspace/meshed-octahedral.ply" "$@")

places=()
for option in --image_path --mask_path --input_path --image_list_path \
  --mask_geometry --original_path --skip_missing_images --skip_missing_masks; do
  value=$("$root/workflows/option_value.sh" "$option" "" "$@")
  if [[ -n $value ]]; then
    places+=("$option" "$value")
  fi
done

octacut=$("$root/workflows/find_octacut.sh")
"$octacut" octahedral_mesher --workspace_path "$workspace" "$@"
OCTACUT=$octacut "$root/workflows/compare_dense.sh" "$workspace" --mesh_path "$mesh" \
  "${places[@]}"
echo "mesh: $mesh"
