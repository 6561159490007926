#!/usr/bin/env bash
# Runs COLMAP on the photographs of an example: feature extraction (inside the
# masks), matching and mapping. Then the model is moved into the frame of the
# example's cameras, so that it can be compared with the reference.
#
#   workflows/run_colmap.sh EXAMPLE OUTPUT
#
# Writes OUTPUT/sparse/0. The colmap package of Debian 12 is sufficient, because no
# GPU is used. An existing model is kept.
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
work=$output/work
rm -rf "$work"
mkdir -p "$work/mapped" "$work/reference" "$output/sparse/0"
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
  --SiftExtraction.use_gpu 0
run exhaustive_matcher --database_path "$work/database.db" \
  --SiftMatching.use_gpu 0
run mapper --database_path "$work/database.db" --image_path "$images" \
  --output_path "$work/mapped"
if [[ ! -f $work/mapped/0/images.bin ]]; then
  echo "run_colmap: the mapper found no model; see $log" >&2
  exit 1
fi

# Camera centres of the example, -R^T t, as "name x y z" lines.
run model_converter --input_path "$example/sparse/0" \
  --output_path "$work/reference" --output_type TXT
awk '!/^#/ && NF == 10 {  # a line of points has a multiple of three
  w = $2; x = $3; y = $4; z = $5
  print $10,
    -((1 - 2*(y*y + z*z))*$6 + 2*(x*y + w*z)*$7 + 2*(x*z - w*y)*$8),
    -(2*(x*y - w*z)*$6 + (1 - 2*(x*x + z*z))*$7 + 2*(y*z + w*x)*$8),
    -(2*(x*z + w*y)*$6 + 2*(y*z - w*x)*$7 + (1 - 2*(x*x + y*y))*$8)
}' "$work/reference/images.txt" >"$work/centers.txt"

diameter=$(awk '{ r = sqrt($2*$2 + $3*$3 + $4*$4); if (r > m) m = r }
                END { print 2 * m }' "$work/centers.txt")
run model_aligner --input_path "$work/mapped/0" \
  --output_path "$output/sparse/0" --ref_images_path "$work/centers.txt" \
  --ref_is_gps 0 --alignment_type custom --robust_alignment 1 \
  --robust_alignment_max_error "$(awk -v d="$diameter" 'BEGIN { print d / 100 }')"
if [[ ! -f $output/sparse/0/images.bin ]]; then
  echo "run_colmap: the model could not be aligned; see $log" >&2
  exit 1
fi
