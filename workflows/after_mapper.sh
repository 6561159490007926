#!/usr/bin/env bash
# From a finished run of COLMAP's mapper to octacut's mesh and its comparison
# with whatever meshes COLMAP made in the same workspace.
#
#   workflows/after_mapper.sh WORKSPACE [options of octacut octahedral_mesher]
#
# WORKSPACE holds images/, masks/ and sparse/ (or what --image_path,
# --mask_path and --input_path name). Safe to run again: it replaces its own
# results and touches nothing else. --output_path belongs on the command line, not
# into a --project_path: the comparison reads it there.
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

octacut=$("$root/workflows/find_octacut.sh")
"$octacut" octahedral_mesher --workspace_path "$workspace" "$@"
OCTACUT=$octacut "$root/workflows/compare_dense.sh" "$workspace" --mesh_path "$mesh"
echo "mesh: $mesh"
