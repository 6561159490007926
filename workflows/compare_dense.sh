#!/usr/bin/env bash
# Compares the dense meshes that COLMAP has left in a workspace with octacut's,
# and writes a page in which a person can look at them.
#
#   workflows/compare_dense.sh WORKSPACE [--mesh_path MESH] [--page 0]
#                              [--image_path DIR] [--mask_path DIR]
#                              [--input_path DIR] [--image_list_path FILE]
#                              [--mask_geometry G] [--original_path DIR]
#                              [--skip_missing_images 1]
#                              [--skip_missing_masks 1]
#                              [options of octacut mesh_comparer]
#
# MESH is octacut's mesh, by default WORKSPACE/meshed-octahedral.ply. The script
# searches WORKSPACE, WORKSPACE/dense and WORKSPACE/dense/* for COLMAP's meshes
# meshed-poisson.ply, meshed-delaunay.ply and meshed-advancing-front.ply.
# Distances are to and from octacut's mesh: they say how far the meshes are apart,
# not which one is right. Where the workspace has photographs and masks, the page
# shows and ranks the meshes by the photographs, octacut's mesh alone if there is
# no other. The script writes WORKSPACE/compare-dense.json and
# WORKSPACE/compare-dense.html, nothing else.
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
page=1
places=() # of photographs, masks and model
masks=
images=$workspace/images
own='mesh_path|page|image_path|mask_path|input_path|image_list_path|mask_geometry'
while [[ ${1:-} =~ ^--($own|original_path|skip_missing_.*)$ ]]; do
  value=${2:?"$1 needs a value"}
  case $1 in
    --mesh_path) mesh=$value ;;
    --page) page=$value ;;
    *) places+=("$1" "$value") ;;
  esac
  [[ $1 == --mask_path ]] && masks=$value
  [[ $1 == --image_path ]] && images=$value
  shift 2
done

if [[ ! -d $workspace ]]; then
  echo "compare_dense: $workspace: no such folder" >&2
  exit 1
fi
# As octacut does: the masks of a dense folder, in which sparse holds the model
# itself, may be those of the workspace around it.
if [[ -z $masks ]]; then
  masks=$workspace/masks
  parent=$(dirname "$(cd "$workspace" && pwd)")
  if [[ ! -d $masks && (-f $workspace/sparse/images.bin || -f $workspace/sparse/images.txt) ]]; then
    for folder in "$(dirname "$parent")" "$parent"; do
      [[ ! -d $folder/masks ]] || masks=$folder/masks
    done
  fi
fi
if [[ ! -f $mesh ]]; then
  echo "compare_dense: $mesh: no such mesh; octacut octahedral_mesher makes it" >&2
  exit 1
fi

inputs=()
meshes=(--mesh_path "$mesh")
own_depths=()
for folder in "$workspace" "$workspace/dense" "$workspace"/dense/*/; do
  for kind in poisson delaunay advancing-front; do
    candidate=${folder%/}/meshed-$kind.ply
    if [[ -f $candidate ]]; then
      inputs+=(--input_path "$candidate")
      meshes+=(--mesh_path "$candidate")
      # octacut depth_map_renderer leaves this beside the maps.
      if [[ -f ${folder%/}/stereo/octacut-depths.json ]]; then
        own_depths+=("$candidate")
      fi
    fi
  done
done

octacut=
if [[ ${#inputs[@]} -gt 0 ]]; then
  octacut=$("$root/workflows/find_octacut.sh")
  "$octacut" mesh_comparer "${inputs[@]}" --reference_path "$mesh" \
    --reference_is_truth 0 --output_path "$workspace/compare-dense.json" "$@"
  echo
  echo "Distances are to and from octacut's mesh: they say how far the meshes are"
  echo "apart, not which one is right. The full report is $workspace/compare-dense.json"
  for candidate in "${own_depths[@]}"; do
    echo "$candidate is made from octacut's depth maps, not from COLMAP's dense stereo."
  done
else
  echo "compare_dense: there is no mesh of COLMAP in $workspace to compare with"
fi

if [[ $page == 1 && -d $masks && -d $images ]]; then
  octacut=${octacut:-$("$root/workflows/find_octacut.sh")}
  echo
  "$octacut" mesh_evaluator --workspace_path "$workspace" "${places[@]}" \
    "${meshes[@]}" --html_path "$workspace/compare-dense.html"
  echo "page: $workspace/compare-dense.html"
elif [[ $page == 1 ]]; then
  for folder in "$masks" "$images"; do
    [[ -d $folder ]] || echo "compare_dense: no page, because there is no folder $folder"
  done
fi
