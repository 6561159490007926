#!/usr/bin/env bash
# Compares the dense meshes that COLMAP has left in a workspace with octacut's.
#
#   workflows/compare_dense.sh WORKSPACE [--mesh_path MESH]
#                              [options of octacut mesh_comparer]
#
# MESH is octacut's mesh, by default WORKSPACE/meshed-octahedral.ply. The script
# searches WORKSPACE, WORKSPACE/dense and WORKSPACE/dense/* for COLMAP's meshes
# meshed-poisson.ply, meshed-delaunay.ply and meshed-advancing-front.ply.
# octacut's mesh is the reference of the distances: they say how far the meshes
# are apart, not which one is right. The only file that the script writes is
# WORKSPACE/compare-dense.json.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 1 || $1 == -* ]]; then
  sed -n '2,/^set/s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
  [[ ${1:-} == -h || ${1:-} == --help ]] && exit 0
  exit 1
fi
workspace=${1%/}
shift
mesh=$workspace/meshed-octahedral.ply
if [[ ${1:-} == --mesh_path ]]; then
  mesh=${2:?"--mesh_path needs a value"}
  shift 2
fi

if [[ ! -d $workspace ]]; then
  echo "compare_dense: $workspace: no such folder" >&2
  exit 1
fi
if [[ ! -f $mesh ]]; then
  echo "compare_dense: $mesh: no such mesh; octacut octahedral_mesher makes it" >&2
  exit 1
fi

inputs=()
for folder in "$workspace" "$workspace/dense" "$workspace"/dense/*/; do
  for kind in poisson delaunay advancing-front; do
    candidate=${folder%/}/meshed-$kind.ply
    if [[ -f $candidate ]]; then
      inputs+=(--input_path "$candidate")
    fi
  done
done
if [[ ${#inputs[@]} -eq 0 ]]; then
  echo "compare_dense: there is no mesh of COLMAP in $workspace to compare with"
  exit 0
fi

octacut=$("$root/workflows/find_octacut.sh")
"$octacut" mesh_comparer "${inputs[@]}" --reference_path "$mesh" \
  --output_path "$workspace/compare-dense.json" "$@"
echo
echo "Distances are to and from octacut's mesh: they say how far the meshes are"
echo "apart, not which one is right. The full report is $workspace/compare-dense.json"
