#!/usr/bin/env bash
# Runs COLMAP on the photographs of an example: feature extraction (inside the
# masks), matching and mapping. Then the model is moved into the frame of the
# example's cameras, so that it can be compared with the reference.
#
#   workflows/run_colmap.sh EXAMPLE OUTPUT
#
# Writes OUTPUT/sparse/0; the database and the mapper's models stay in OUTPUT/work.
# The colmap package of Debian 12 is sufficient, because no GPU is used. An
# existing model is kept.
set -euo pipefail

if [[ $# -ne 2 ]]; then
  echo "usage: $0 EXAMPLE OUTPUT" >&2
  exit 1
fi
example=$1
output=$2
images=$example/images

if [[ -f $output/sparse/0/images.bin ]]; then
  echo "$output/sparse/0 exists already"
  exit 0
fi
if ! command -v colmap >/dev/null; then
  echo "run_colmap: COLMAP is not installed (package colmap in Debian)" >&2
  exit 1
fi

export QT_QPA_PLATFORM=offscreen
workflows=$(dirname "${BASH_SOURCE[0]}")
# shellcheck source-path=SCRIPTDIR source=colmap_options.sh
source "$workflows/colmap_options.sh"
work=$output/work
rm -rf "$work"
mkdir -p "$work/mapped" "$output"
log=$output/colmap.log
: >"$log"

run() {
  echo "colmap $1"
  if ! colmap "$@" >>"$log" 2>&1; then
    echo "run_colmap: colmap $1 failed; see $log" >&2
    exit 1
  fi
}

run feature_extractor --database_path "$work/database.db" \
  --image_path "$images" --ImageReader.mask_path "$example/masks" \
  --ImageReader.single_camera 1 --ImageReader.camera_model SIMPLE_RADIAL \
  --"$extraction".use_gpu 0
run exhaustive_matcher --database_path "$work/database.db" \
  --"$matching".use_gpu 0
run mapper --database_path "$work/database.db" --image_path "$images" \
  --output_path "$work/mapped"
model=$(largest_model "$work/mapped")
if [[ -z $model ]]; then
  echo "run_colmap: the mapper found no model; see $log" >&2
  exit 1
fi

"$workflows/align_model.sh" "$example/sparse/0" "$model" "$output/sparse/0" "$log"
