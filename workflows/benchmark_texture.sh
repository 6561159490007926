#!/usr/bin/env bash
# benchmark_texture.sh DATA MESHES [options]
#
# Textures meshes of data sets with each eighth photograph left out, and prints
# the table of docs/texture.md: how well pictures of the textured mesh agree with
# these photographs, against the vertex colours of the same mesh and of the full
# one. DATA holds a folder for each set with images, masks and a sparse model.
# MESHES holds SET.ply, the full mesh with vertex colours, and SET_100k.ply, the
# same simplified to 100,000 triangles with its colours carried along. Nothing is
# written to DATA, and to MESHES only with --make_meshes 1.
#
#   --make_meshes 1       reconstruct what MESHES lacks (512^3 voxels) from the
#                         photographs that are not left out, so that neither
#                         the meshes nor their colours know the others
#   --sets LIST           comma-separated; default: all that are in both
#   --work_path FOLDER    for textured meshes, pictures, reports; default
#                         build/texture
#   --view_blending NAME  best (default) or median
#   --pictures_path DIR   also write the pictures of docs/texture.md there: each
#                         set, and igea with 3,000 triangles without and with a
#                         normal map
#   --large_set SET       also texture SET's full mesh, simplified to 300,000
#                         triangles, from all photographs, and print what it took
#   --num_threads N       default 1
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$root/build/texture
threads=1
blending=best
make_meshes=0
sets=
pictures=
large_set=
folders=()
while (($#)); do
  case $1 in
    --help | -h)
      sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --sets) sets=${2:?"$1 needs a value"} && shift 2 ;;
    --work_path) work=${2:?"$1 needs a value"} && shift 2 ;;
    --view_blending) blending=${2:?"$1 needs a value"} && shift 2 ;;
    --make_meshes) make_meshes=${2:?"$1 needs a value"} && shift 2 ;;
    --pictures_path) pictures=${2:?"$1 needs a value"} && shift 2 ;;
    --large_set) large_set=${2:?"$1 needs a value"} && shift 2 ;;
    --num_threads) threads=${2:?"$1 needs a value"} && shift 2 ;;
    -*)
      echo "benchmark_texture: $1: no such option; --help lists them" >&2
      exit 1
      ;;
    *) folders+=("$1") && shift ;;
  esac
done
if [[ ${#folders[@]} -ne 2 || ! -d ${folders[0]} || ! -d ${folders[1]} ]]; then
  echo "benchmark_texture: the folders DATA and MESHES are needed; --help says more" >&2
  exit 1
fi
data=${folders[0]}
meshes=${folders[1]}
octacut=$("$root/workflows/find_octacut.sh")
mkdir -p "$work" ${pictures:+"$pictures"}
TIMEFORMAT=%U
# Sets whose licences allow a picture in the documentation.
pictured=(example igea rocker temple)

# The sparse model in whose frame the meshes of a set are.
find_model() {
  local model=$data/$1/sparse
  [[ -d $data/$1/sparse_gt ]] && model=$data/$1/sparse_gt
  echo "$model"
}

# A workspace of links without each eighth photograph, and its mesh.
make_mesh() {
  local name=$1 workspace=$work/$1_workspace number=0 image
  rm -rf "$workspace"
  mkdir -p "$workspace/images"
  # In the order in which mesh_texturer --hold_out counts.
  while read -r image; do
    if ((number++ % 8 != 0)); then
      ln -s "$(realpath "$data/$name/images/$image")" "$workspace/images/"
    fi
  done < <(find "$data/$name/images/" -maxdepth 1 ! -type d -printf '%f\n' | LC_ALL=C sort)
  "$octacut" octahedral_mesher --workspace_path "$workspace" \
    --input_path "$(find_model "$name")" --mask_path "$data/$name/masks" \
    --skip_missing_images 1 --output_path "$meshes/$name.ply" \
    --num_threads "$threads" &>"$work/${name}_mesh.log"
}

if [[ -z $sets ]]; then
  for mesh in "$meshes"/*_100k.ply; do
    name=$(basename "$mesh" _100k.ply)
    [[ -d $data/$name ]] && sets+=${sets:+,}$name
  done
fi

echo "| set | PSNR, dB: texture | vertex colours, same mesh | full mesh | noise | SSIM: texture | same mesh | full mesh | seams, grey levels: before | after | charts | pages | CPU s | GB |"
echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"
for name in ${sets//,/ }; do
  model=$(find_model "$name")
  if [[ $make_meshes == 1 && ! -e $meshes/$name.ply ]]; then
    make_mesh "$name"
  fi
  if [[ $make_meshes == 1 && ! -e $meshes/${name}_100k.ply ]]; then
    "$octacut" mesh_simplifier --input_path "$meshes/$name.ply" \
      --output_path "$meshes/${name}_100k.ply" --target_faces 100000 \
      --num_threads "$threads" &>"$work/${name}_simplifier.log"
  fi
  folder=$work
  if [[ -n $pictures && " ${pictured[*]} " == *" $name "* ]]; then
    folder=$pictures
  fi
  { time "$octacut" mesh_texturer --workspace_path "$data/$name" \
    --input_path "$model" --mesh_path "$meshes/${name}_100k.ply" \
    --output_path "$work/$name.glb" --report_path "$work/$name.json" \
    --picture_path "$folder/texture_$name.jpg" --view_blending "$blending" --hold_out 8 \
    --compare_path "$meshes/$name.ply" --num_threads "$threads" \
    >"$work/$name.log" 2>&1; } 2>"$work/$name.cpu" || {
    echo "benchmark_texture: $name: $(tail -n 1 "$work/$name.log")" >&2
    exit 1
  }
  jq -r --arg name "$name" --arg cpu "$(tail -n 1 "$work/$name.cpu")" '
    def fixed(n): . * pow(10; n) | round / pow(10; n) | tostring;
    .peak_memory_bytes as $bytes | .texture as $t
    | [$name]
      + [$t.held_out.meshes[].psnr | fixed(2)]
      + [$t.held_out.noise_psnr | fixed(1)]
      + [$t.held_out.meshes[].ssim | fixed(3)]
      + [$t.seams.mean_jump_before, $t.seams.mean_jump_after | fixed(2)]
      + [$t.charts, $t.pages | tostring]
      + [$cpu, ($bytes / 1e9 | fixed(1))]
    | "| " + join(" | ") + " |"' "$work/$name.json"
done

fail() {
  echo "benchmark_texture: $1: $(tail -n 1 "$2")" >&2
  exit 1
}

# simplify SET NUMBER
simplify() {
  "$octacut" mesh_simplifier --input_path "$meshes/$1.ply" \
    --output_path "$work/$1_$2.ply" --target_faces "$2" \
    --num_threads "$threads" &>"$work/$1_simplifier.log" ||
    fail "$1" "$work/$1_simplifier.log"
}

if [[ -n $pictures && -e $meshes/igea.ply ]]; then
  simplify igea 3000
  for kind in flat normal_map; do
    options=()
    [[ $kind == normal_map ]] && options=(--normal_map_from "$meshes/igea.ply")
    "$octacut" mesh_texturer --workspace_path "$data/igea" \
      --input_path "$(find_model igea)" --mesh_path "$work/igea_3000.ply" \
      --output_path "$work/igea_$kind.glb" "${options[@]}" \
      --picture_path "$pictures/texture_igea_$kind.jpg" \
      --num_threads "$threads" &>"$work/igea_$kind.log" ||
      fail "igea, $kind" "$work/igea_$kind.log"
  done
fi

if [[ -n $large_set ]]; then
  simplify "$large_set" 300000
  { time "$octacut" mesh_texturer --workspace_path "$data/$large_set" \
    --input_path "$(find_model "$large_set")" \
    --mesh_path "$work/${large_set}_300000.ply" --num_threads "$threads" \
    --output_path "$work/large.glb" --report_path "$work/large.json" \
    >"$work/large.log" 2>&1; } 2>"$work/large.cpu" ||
    fail "$large_set" "$work/large.log"
  jq -r --arg name "$large_set" --arg cpu "$(tail -n 1 "$work/large.cpu")" '
    "\n\($name), \(.texture.triangles) triangles, \(.texture.photographs.used) photographs: \($cpu) CPU s, \(.peak_memory_bytes / 1e9 * 10 | round / 10) GB"
  ' "$work/large.json"
fi
