#!/usr/bin/env bash
# Measures accuracy on scenes with ground truth, on hard and on worsened ones and
# with one option changed at a time, and what silhouettes and photographs say of
# the real sets without truth. Writes docs/accuracy.md and its pictures.
#
#   workflows/benchmark_accuracy.sh [DATA_FOLDER] [options]
#
# DATA_FOLDER           default: $OCTACUT_SHARED_DATA, else ../shared/data
#                       beside the source tree; only read. What is not there is
#                       left out
# --level 8             of octacut's own scenes: (2^level)^3 voxels
# --data_level 9        of the data sets
# --only PART,...       of scenes, hard, degraded, ablations
# --scenes SCENE,...    these alone
# --sets SET,...        these option sets and degradations alone
# --list 1              only say what would be run
# --work_path DIR       scenes, meshes, reports; default build/accuracy
# --results_path FILE   default docs/accuracy.md; pictures go beside it
# --num_threads 2
# --redo 1              also what is up to date: made after the executable, with
#                       the same options
#
# What is not run keeps the figures of an earlier run, where those are up to
# date; a run that was interrupted goes on where it was. The scenes alone took
# half an hour on two cores (--level 7 --data_level 9). Exits with 1 when
# something failed; what has worked is written.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck source-path=SCRIPTDIR source=measuring.sh
source "$root/workflows/measuring.sh"

# Scenes of octacut's own: name, options of example_creator. The numbers of
# rods and fingers are their thickness in voxels of 128^3; fingers at the tips.
own_scenes=(
  "example --scene example --reference_resolution 200"
  "lump --scene lump --Scene.texture marble --reference_resolution 120"
  "cup-1 --scene cup --reference_resolution 120"
  "cup-2 --scene cup --Scene.cup_depth 2 --reference_resolution 120"
  "rods-2 --scene rods --Scene.rod_radius 0.0152 --reference_resolution 250"
  "rods-3 --scene rods --Scene.rod_radius 0.0228 --reference_resolution 200"
  "rods-5 --scene rods --Scene.rod_radius 0.038 --reference_resolution 150"
  "fingers-2 --scene fingers --Scene.finger_radius 0.0133 --reference_resolution 250"
  "fingers-3 --scene fingers --Scene.finger_radius 0.02 --reference_resolution 200"
  "fingers-5 --scene fingers --Scene.finger_radius 0.0333 --reference_resolution 150"
  "touching --scene touching_spheres --reference_resolution 120"
  "shiny --scene sphere --Scene.specular 0.6 --reference_resolution 120"
  "walls --scene box --Scene.plain_share 0.4 --reference_resolution 120"
  "near-and-far --scene example --Rig.far_factor 3 --reference_resolution 200"
  "turntable-light --scene torus --Scene.lights_fixed_to_camera 1 --reference_resolution 120"
)
# Their parts are too thin for a hull of 128^3: hull_level 8.
thin_scenes=(rods-2 fingers-2)
# For all of them: pictures small enough that a run at 256^3 takes some 20 s.
own_options=(--width 640 --height 480 --num_views 36)

# Data sets: name, folder, model, ground truth, whether the mesh is aligned to
# that first (the mapper's cameras agree with the exact ones only nearly), levels
# beyond --data_level.
data_sets=(
  "igea-exact       igea   sparse_gt gt/mesh.ply 0 0"
  "igea-mapper      igea   sparse/0  gt/mesh.ply 1 0"
  "igea-exact-fine  igea   sparse_gt gt/mesh.ply 0 1"
  "igea-mapper-fine igea   sparse/0  gt/mesh.ply 1 1"
  "rocker-exact     rocker sparse_gt gt/mesh.ply 0 0"
  "rocker-mapper    rocker sparse/0  gt/mesh.ply 1 0"
  "temple           temple sparse/0  -           0 0"
  "dino             dino   sparse/0  -           0 0"
  "bunny            bunny  sparse/0  -           0 0"
)

# Those in which photographs decide little, or folds hide what is in them: of
# octacut's own, of the data sets' true meshes photographed in other materials,
# and of the data sets.
hard_scenes=(
  "metal --scene example --Scene.material metal --Degrade.pixel_noise 1 --reference_resolution 200"
  "porcelain --scene example --Scene.material porcelain --Degrade.pixel_noise 1 --reference_resolution 200"
  "plaster --scene example --Scene.material plaster --Degrade.pixel_noise 1.5 --reference_resolution 200"
  "metal-cup --scene cup --Scene.material metal --Degrade.pixel_noise 1 --reference_resolution 150"
  "plaster-cup --scene cup --Scene.material plaster --Degrade.pixel_noise 1 --reference_resolution 150"
  "metal-box --scene box --Scene.material metal --Degrade.pixel_noise 1 --reference_resolution 150"
  "porcelain-lump --scene lump --Scene.material porcelain --Degrade.pixel_noise 1 --reference_resolution 150"
  "drapery-1 --scene drapery --Scene.fold_depth 1 --reference_resolution 160"
  "drapery-2 --scene drapery --Scene.fold_depth 2 --reference_resolution 160"
  "drapery-4 --scene drapery --Scene.fold_depth 4 --reference_resolution 160"
  "metal-rocker --mesh_path DATA_FOLDER/rocker/gt/mesh.ply --Scene.material metal --Degrade.pixel_noise 1"
  "plaster-rocker --mesh_path DATA_FOLDER/rocker/gt/mesh.ply --Scene.material plaster --Degrade.pixel_noise 1"
  "metal-igea --mesh_path DATA_FOLDER/igea/gt/mesh.ply --Scene.material metal --Degrade.pixel_noise 1"
  "plaster-igea --mesh_path DATA_FOLDER/igea/gt/mesh.ply --Scene.material plaster --Degrade.pixel_noise 1"
  "metal-homer --mesh_path DATA_FOLDER/homer/gt/mesh.ply --Scene.material metal --Degrade.pixel_noise 1"
  "porcelain-cheburashka --mesh_path DATA_FOLDER/cheburashka/gt/mesh.ply --Scene.material porcelain --Degrade.pixel_noise 1"
  "plaster-cheburashka --mesh_path DATA_FOLDER/cheburashka/gt/mesh.ply --Scene.material plaster --Degrade.pixel_noise 1"
)
hard_data_sets=(
  "bird         bird        sparse/0  -           0 0"
  "ethiopian    ethiopian   sparse/0  -           0 0"
  "homer-exact  homer       sparse_gt gt/mesh.ply 0 0"
  "cheburashka  cheburashka sparse_gt gt/mesh.ply 0 0"
)
# What is held against each other there; hull-default is visual_hull_mesher as
# it is without options.
hard_sets=(hull-default no-refinement default)
# Where the drapery's folds are wider than 8 pixels all along.
wide_folds=-0.2,-2,-2,2,2,2

# What is made worse of own scenes.
degradations=(
  "noise-5     --Degrade.pixel_noise 5"
  "eroded-1    --Degrade.mask_offset -1"
  "eroded-2    --Degrade.mask_offset -2"
  "eroded-4    --Degrade.mask_offset -4"
  "dilated-1   --Degrade.mask_offset 1"
  "dilated-2   --Degrade.mask_offset 2"
  "dilated-4   --Degrade.mask_offset 4"
  "holes       --Degrade.num_mask_holes 12 --Degrade.num_mask_specks 12 --Degrade.mask_defect_radius 3"
  "large-holes --Degrade.num_mask_holes 6 --Degrade.mask_defect_radius 9"
  "poses-0.25  --Degrade.pose_noise 0.25"
  "poses-0.5   --Degrade.pose_noise 0.5"
  "poses-1     --Degrade.pose_noise 1"
)

# One option changed at a time, on which scenes. The first set is the default;
# `hull` is no option set but the visual hull alone; without evidence thin parts
# need more ballooning than by default, or nothing is left. `Group.key=value` goes
# into a project file, which also has keys that the command line has not
# (docs/project_file.md).
ablated_scenes=(example lump cup-1 rods-3 rocker-exact)
# And single ones, where a scene shows what an option is for: the deep cup has
# handles to remove and a bottom that few views see, dino plain plaster and
# shadows that its masks take for background.
single_ablations=(
  "cup-2 all-handles" "cup-2 agreeing-1" "cup-2 no-plausible"
  "walls agreeing-1" "walls no-plausible" "walls no-ballooning"
  "walls ncc" "walls variance" "walls chroma-1"
  "shiny ncc" "shiny variance" "shiny chroma-1"
  "turntable-light ncc" "turntable-light variance" "turntable-light chroma-1"
  "dino no-ballooning" "dino no-cover" "dino masks-trusted"
  "dino gaps-kept"
  "temple masks-trusted"
)
option_sets=(
  "default"
  "hull"
  "no-refinement   OctahedralMeshing.refine=0"
  "no-evidence     OctahedralMeshing.matter_weight=0 OctahedralMeshing.free_space_weight=0 OctahedralMeshing.ballooning=0.5"
  "agreeing-1      OctahedralMeshing.min_agreeing_views=1"
  "no-plausible    OctahedralMeshing.min_like_samples=9"
  "neighbors-2     DepthSweep.num_neighbors=2"
  "no-ballooning   OctahedralMeshing.ballooning=0"
  "no-cover        OctahedralMeshing.cover_rounds=0"
  "no-silhouettes  OctahedralMeshing.silhouette_weight=0"
  "ncc             OctahedralMeshing.consistency=ncc"
  "variance        OctahedralMeshing.consistency=variance"
  "chroma-1        OctahedralMeshing.chroma_weight=1"
  "chroma-4        OctahedralMeshing.chroma_weight=4"
  "no-growing      OctahedralMeshing.max_grow_rounds=0"
  "no-smoothing    Smoothing.iterations=0"
  "smoothing-5     Smoothing.iterations=5"
  "taubin          Smoothing.taubin_mu=-0.53"
  "no-alignment    Refinement.alignment_steps=0"
  "coarse-once     Refinement.coarse_passes=1"
  "all-handles     OctahedralMeshing.min_handle=0"
  "mask-tolerance-0 OctahedralMeshing.mask_tolerance=0"
  "masks-trusted   OctahedralMeshing.move_mask_borders=0"
  "gaps-kept       OctahedralMeshing.fill_false_gaps=0"
)

fail() {
  echo "benchmark_accuracy: $*" >&2
  exit 1
}

# write_project_files: of each option set one, unless it is there already: what is
# newer than a mesh makes that stale.
write_project_files() {
  local set words file
  mkdir -p "$work/sets"
  for set in "${option_sets[@]}"; do
    read -ra words <<<"$set"
    file=$work/sets/${words[0]}.ini
    printf '%s\n' "${words[@]:1}" >"$file.new"
    if cmp -s "$file.new" "$file"; then
      rm "$file.new"
    else
      mv "$file.new" "$file"
    fi
  done
}

data=${OCTACUT_SHARED_DATA:-$root/../shared/data}
build=${OCTACUT_BUILD_DIR:-$root/build}
work=$build/accuracy
results=$root/docs/accuracy.md
level=8
data_level=9
only=
scenes=
sets=
list=0
threads=2
redo=0
command=workflows/benchmark_accuracy.sh
[[ $# -eq 0 || $1 == -* ]] || command+=" DATA_FOLDER"
while [[ $# -gt 0 ]]; do
  case $1 in
    -h | --help)
      sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"
      exit 0
      ;;
    --level) level=${2:?"$1 needs a value"} ;;
    --data_level) data_level=${2:?"$1 needs a value"} ;;
    --only) only=${2:?"$1 needs a value"} ;;
    --scenes) scenes=${2:?"$1 needs a value"} ;;
    --sets) sets=${2:?"$1 needs a value"} ;;
    --list) list=${2:?"$1 needs 0 or 1"} ;;
    --work_path) work=${2:?"$1 needs a value"} ;;
    --results_path) results=${2:?"$1 needs a value"} ;;
    --num_threads) threads=${2:?"$1 needs a value"} ;;
    --redo) redo=${2:?"$1 needs 0 or 1"} ;;
    -*) fail "$1: no such option; --help lists them" ;;
    *)
      data=$1
      shift
      continue
      ;;
  esac
  [[ $1 == --work_path || $1 == --redo ]] || command+=" $1 $2"
  shift 2
done
for value in "$level" "$data_level"; do
  [[ $value =~ ^[2-9]$|^10$ ]] || fail "level = $value: must be 2 to 10"
done
[[ $threads =~ ^[1-9][0-9]*$ ]] ||
  fail "num_threads = $threads: must be at least 1"
[[ $redo$list =~ ^[01][01]$ ]] || fail "redo, list: must be 0 or 1"
check_names() {
  local unknown
  unknown=$(unknown_of "$2" "${@:3}")
  [[ -z $unknown ]] || fail "$1 = $unknown: there are ${*:3}"
}
check_names only "$only" scenes hard degraded ablations
made_scenes=("${own_scenes[@]}" "${hard_scenes[@]}")
all_data_sets=("${data_sets[@]}" "${hard_data_sets[@]}")
check_names scenes "$scenes" "${made_scenes[@]%% *}" "${all_data_sets[@]%% *}"
check_names sets "$sets" "${option_sets[@]%% *}" "${hard_sets[@]}" \
  "${degradations[@]%% *}"

[[ -d $data ]] && data=$(cd "$data" && pwd)
if ((!list)); then
  command -v jq >/dev/null || "$root/workflows/setup.sh"
  octacut=$("$root/workflows/find_octacut.sh")
  mkdir -p "$work" "$(dirname "$results")"
  work=$(cd "$work" && pwd)
  # The executable's time at the start: a build may replace it meanwhile.
  stamp=$work/executable
  touch -r "$octacut" "$stamp"
  write_project_files
fi

# line_of NAME LINE...: the options of the line that begins with the name, into
# the array `options`.
line_of() {
  local line words
  for line in "${@:2}"; do
    read -ra words <<<"$line"
    if [[ ${words[0]} == "$1" ]]; then
      options=("${words[@]:1}")
      return
    fi
  done
  return 1
}

# is_made FOLDER NAME REPORT SOURCES COMMAND OPTION...: the step was done with
# this executable and these options, and its REPORT is newer than the SOURCES
# (separated by blanks).
# shellcheck disable=SC2317 # called by its name
is_made() {
  local folder=$1 name=$2 report=$3 sources=$4
  shift 4
  # shellcheck disable=SC2086 # of folders without blanks
  [[ -f $folder/$name.options ]] &&
    [[ $(<"$folder/$name.options") == "$*" ]] && fresh "$report" $sources
}

# made FOLDER NAME REPORT SOURCES COMMAND OPTION...: `step`, unless it is_made.
# Its options are noted when it is done.
# shellcheck disable=SC2317 # called by its name
made() {
  local folder=$1 name=$2
  if ((!redo)) && is_made "$@"; then
    return 0
  fi
  shift 4
  mkdir -p "$folder"
  rm -f "$folder/$name.options"
  step "$folder" "$name" "$@" || return 1
  echo "$*" >"$folder/$name.options"
}

# The functions below are run under `if`, where set -e does not hold.

# with_scene CHECK SCENE DEGRADATION: CHECK (is_made or made) of an own scene in
# $work/scenes.
with_scene() {
  local scene=$2 degradation=$3 folder=$work/scenes/$2/$3
  local options=() all=("${own_options[@]}")
  line_of "$scene" "${made_scenes[@]}"
  all+=("${options[@]}")
  if [[ $degradation != clean ]]; then
    line_of "$degradation" "${degradations[@]}"
    all+=("${options[@]}")
  fi
  "$1" "$work/scenes/$scene" "$degradation" "$folder/example.json" "" \
    example_creator --output_path "$folder" --overwrite 1 \
    "${all[@]/#DATA_FOLDER/$data}"
}

# is_missing SCENE: an own scene photographs a mesh that is not there.
is_missing() {
  local options=() option
  line_of "$1" "${made_scenes[@]}" || return 1
  for option in "${options[@]}"; do
    if [[ $option == DATA_FOLDER/* && ! -f ${option/#DATA_FOLDER/$data} ]]; then
      return 0
    fi
  done
  return 1
}

is_thin() {
  [[ " ${thin_scenes[*]} " == *" $1 "* ]]
}

# level_of SCENE: where its runs end.
level_of() {
  local options=()
  if line_of "$1" "${all_data_sets[@]}"; then
    echo "$((data_level + options[4]))"
  elif is_thin "$1"; then
    echo "$((level > 8 ? level : 8))"
  else
    echo "$level"
  fi
}

# hull_level_of SCENE LEVEL: where a run that ends at LEVEL begins.
hull_level_of() {
  local first=7
  if is_thin "$1"; then first=8; fi
  echo "$(($2 < first ? $2 : first))"
}

# with_comparison CHECK NAME ALIGN MIN_VIEWS OPTION...: CHECK of a comparison of
# the mesh with what so many cameras see of the truth.
with_comparison() {
  "$1" "$folder" "$2" "$folder/$2.json" \
    "$folder/mesh.json $judge/$truth" mesh_comparer \
    --input_path "$folder/mesh.ply" --reference_path "$judge/$truth" \
    --views_path "$judge/$model" --min_views "$4" --align "$3" \
    --num_samples 200000 --self_intersections 0 "${@:5}" \
    --output_path "$folder/$2.json"
}

# parts: the steps of the run that `run` is at. Worse poses are held against an
# aligned clean mesh, since they are aligned themselves; the deep cup is for what
# only two views see; of drapery wide folds are judged apart from all.
parts() {
  local parts=mesh options=()
  if [[ $truth != - ]]; then
    parts+=" comparison"
    [[ $scene != drapery-* ]] || parts+=" wide_folds"
    if [[ $folder == */clean/default ]] &&
      line_of "$scene" "${own_scenes[@]}"; then
      parts+=" aligned"
      [[ $scene != cup-2 ]] || parts+=" two_views"
    fi
  fi
  echo "$parts evaluation"
}

# with_step CHECK NAME: CHECK (is_made or made) of a step of the run that `run`
# is at: mesh, one of the comparisons or evaluation. `judge` is the workspace
# with the right cameras, masks and images.
with_step() {
  local check=$1 name=$2 options=() first project=
  case $name in
    mesh)
      if [[ $set == hull ]]; then
        options=(visual_hull_mesher --OctahedralMeshing.hull_level "$at")
      elif [[ $set == hull-default ]]; then
        options=(visual_hull_mesher)
      else
        line_of "$set" "${option_sets[@]}"
        first=$(hull_level_of "$scene" "$at")
        ((!${#options[@]})) || project=$work/sets/$set.ini
        options=(octahedral_mesher --OctahedralMeshing.hull_level "$first"
          --OctahedralMeshing.target_level "$at"
          ${project:+--project_path "$project"})
      fi
      "$check" "$folder" mesh "$folder/mesh.json" \
        "$workspace/images $workspace/masks $workspace/$model $project" \
        "${options[0]}" --workspace_path "$workspace" \
        --input_path "$workspace/$model" --output_path "$folder/mesh.ply" \
        "${options[@]:1}"
      ;;
    comparison)
      if [[ $scene == drapery-* ]]; then
        with_comparison "$check" "$name" "$align" 2 --max_view_angle 80
      else
        with_comparison "$check" "$name" "$align" 3
      fi
      ;;
    wide_folds)
      with_comparison "$check" "$name" "$align" 2 --max_view_angle 80 \
        --bounding_box "$wide_folds"
      ;;
    aligned) with_comparison "$check" "$name" 1 3 ;;
    two_views) with_comparison "$check" "$name" "$align" 2 ;;
    evaluation)
      # What the truth itself scores says how good masks and images are.
      local meshes=(--mesh_path "$folder/mesh.ply")
      if [[ $truth != - && $align == 0 && $folder == */clean/default ]]; then
        meshes+=(--mesh_path "$judge/$truth")
      fi
      "$check" "$folder" evaluation "$folder/evaluation.json" \
        "$folder/mesh.json $judge/masks $judge/images" mesh_evaluator \
        --workspace_path "$judge" --input_path "$judge/$model" "${meshes[@]}" \
        --output_path "$folder/evaluation.json"
      ;;
  esac
}

# with_run CHECK: CHECK of all that the run that `run` is at takes.
with_run() {
  if [[ $dataset == - ]]; then
    with_scene "$1" "$scene" clean || return 1
    [[ $degradation == clean ]] ||
      with_scene "$1" "$scene" "$degradation" || return 1
  fi
  local part
  for part in $(parts); do
    with_step "$1" "$part" || return 1
  done
}

# record STATE MESSAGE PART: a line of JSON about the run that `run` is at, for the
# tables. Paths of this machine are no figures.
record() {
  local part message=${2//"$work"/WORK} cpu=null
  [[ -f $folder/mesh.cpu && $1 != left_out ]] && cpu=$(<"$folder/mesh.cpu")
  local arguments=(--arg part "$3" --arg state "$1"
    --arg message "${message//"$data"/DATA_FOLDER}" --arg scene "$scene" --arg degradation "$degradation" --arg set "$set"
    --argjson level "$at" --argjson cpu "${cpu:-null}")
  for part in mesh comparison wide_folds aligned two_views evaluation; do
    if [[ $1 != left_out && " $(parts) " == *" $part "* ]] &&
      with_step is_made "$part"; then
      arguments+=(--slurpfile "$part" "$folder/$part.json")
    else
      arguments+=(--argjson "$part" "[]")
    fi
  done
  # Nothing but colours, picture and writing follow refinement.
  # shellcheck disable=SC2016 # variables of jq
  jq -nc "${arguments[@]}" 'def judged: .[0].meshes[0].comparison;
    {part: $part, scene: $scene, degradation: $degradation,
    set: $set, level: $level, state: $state, message: $message,
    cpu_seconds: $cpu, seconds: $mesh[0].seconds, audit: $mesh[0].audit,
    refine_seconds: $mesh[0].reconstruction.refinement.seconds,
    late_seconds: ([$mesh[0].phases[]?
      | select(.name | IN("vertex colours", "picture")) | .seconds] | add),
    version: $mesh[0].version, truth: $comparison[0].reference.audit,
    comparison: ($comparison | judged), aligned: ($aligned | judged),
    two_views: ($two_views | judged), wide_folds: ($wide_folds | judged),
    evaluation: $evaluation[0].meshes[0],
    truth_evaluation: $evaluation[0].meshes[1]}
    | del(.evaluation.silhouettes.views, .truth_evaluation.silhouettes.views)'
}

# run PART SCENE DEGRADATION SET: does it where it is wanted, records it.
run() {
  local part=$1 scene=$2 degradation=$3 set=$4
  local which=$set wanted=1
  [[ $degradation == clean ]] || which=$degradation
  is_among "$part" "$only" && is_among "$scene" "$scenes" &&
    is_among "$which" "$sets" || wanted=0
  ((!list || wanted)) || return 0
  local name="$scene $degradation $set" workspace judge at
  at=$(level_of "$scene")
  local dataset=- model=sparse/0 truth=gt/reference.ply align=0 options
  if line_of "$scene" "${all_data_sets[@]}"; then
    dataset=${options[0]} model=${options[1]} truth=${options[2]}
    align=${options[3]}
    workspace=$data/$dataset judge=$data/$dataset
  else
    workspace=$work/scenes/$scene/$degradation judge=$work/scenes/$scene/clean
    # Where all poses are off, so is the frame that they stand for.
    [[ $degradation != poses-* ]] || align=1
  fi
  local folder=$work/level_$at/$scene/$degradation/$set
  if ((list)); then
    echo "$part: $name at level $at"
    return 0
  fi
  error=
  local state="done"
  if ((!wanted)); then
    with_run is_made || state=left_out
  elif [[ $dataset != - && ! -d $workspace/$model ]]; then
    state=left_out
    error="skipped: $workspace/$model is missing"
    echo "== $name: $error"
  elif is_missing "$scene"; then
    state=left_out
    error="skipped: the mesh that it photographs is missing"
    echo "== $name: $error"
  else
    echo "== $name"
    if ! with_run made; then
      state=failed
      failed=1
      echo "benchmark_accuracy: $name: $error" >&2
    fi
  fi
  record "$state" "$error" "$part" >>"$records"
  if [[ $part =~ ^(scenes|hard)$ && $set == default && $state != left_out ]] &&
    with_step is_made mesh; then
    # The licences of these sets allow measuring, not showing.
    [[ $scene =~ ^(bird|bunny|dino|ethiopian)$ ]] ||
      pictures[$scene]=$folder/mesh.png
  fi
}

# sheet FILE WIDTH SCENE...: their default meshes side by side, of those there
# are.
sheet() {
  local file=$1 width=$2 scene shown=()
  for scene in "${@:3}"; do
    if [[ -f ${pictures[$scene]-} ]]; then
      shown+=("$scene" "${pictures[$scene]}")
    fi
  done
  if ((${#shown[@]})); then
    "$build/tests/bench/octacut_contact_sheet" "$file" 2 "$width" "${shown[@]}"
  fi
}

trap 'exit 130' INT
failed=0
declare -A pictures=() # of the scenes' default meshes
records=$work/runs_${level}_$data_level.jsonl
((list)) || : >"$records"
for scene in "${own_scenes[@]%% *}" "${data_sets[@]%% *}"; do
  run scenes "$scene" clean default
done
for scene in "${hard_scenes[@]%% *}" "${hard_data_sets[@]%% *}"; do
  for set in "${hard_sets[@]}"; do
    run hard "$scene" clean "$set"
  done
done
for scene in "${own_scenes[@]%% *}"; do
  for degradation in "${degradations[@]%% *}"; do
    run degraded "$scene" "$degradation" default
  done
done
for scene in "${ablated_scenes[@]}"; do
  for set in "${option_sets[@]:1}"; do
    run ablations "$scene" clean "${set%% *}"
  done
done
for pair in "${single_ablations[@]}"; do
  run ablations "${pair% *}" clean "${pair#* }"
done
((!list)) || exit 0

"$root/workflows/build.sh" octacut_contact_sheet >"$work/build.log"
beside=$(dirname "$results")
sheet "$beside/accuracy_own.jpg" 560 "${own_scenes[@]%% *}"
mapfile -t shown < <(printf '%s\n' "${data_sets[@]%% *}" | grep -v -e -fine)
sheet "$beside/accuracy_data.jpg" 560 "${shown[@]}"
sheet "$beside/accuracy_hard.jpg" 560 "${hard_scenes[@]%% *}" \
  "${hard_data_sets[@]%% *}"

printf '%s\n' "${own_scenes[@]}" >"$work/own_scenes.txt"
printf '%s\n' "${hard_scenes[@]}" >"$work/hard_scenes.txt"
printf '%s\n' "${degradations[@]}" >"$work/degradations.txt"
printf '%s\n' "${option_sets[@]}" >"$work/option_sets.txt"
jq -L "$root/workflows" -rs --arg machine "$(machine)" \
  --arg command "$command" --argjson level "$level" \
  --argjson data_level "$data_level" --argjson threads "$threads" \
  --rawfile own_scenes "$work/own_scenes.txt" \
  --rawfile hard_scenes "$work/hard_scenes.txt" \
  --rawfile degradations "$work/degradations.txt" \
  --rawfile option_sets "$work/option_sets.txt" \
  -f "$root/workflows/accuracy_tables.jq" "$records" >"$results.part"
mv "$results.part" "$results"
echo
echo "written: $results"
if [[ $octacut -nt $stamp ]]; then
  fail "$octacut was replaced meanwhile: the figures are of both; run again"
fi
exit "$failed"
