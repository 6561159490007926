#!/usr/bin/env bash
# Moves a sparse model into the frame of another one of the same photographs, by
# the centres of their cameras, so that meshes of both can be compared.
#
#   workflows/align_model.sh REFERENCE_MODEL MODEL OUTPUT_MODEL LOG
#
# COLMAP's messages are appended to LOG.
set -euo pipefail

if [[ $# -ne 4 ]]; then
  echo "usage: $0 REFERENCE_MODEL MODEL OUTPUT_MODEL LOG" >&2
  exit 1
fi
reference=$1
model=$2
output=$3
log=$4
export QT_QPA_PLATFORM=offscreen
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

run() {
  echo "colmap $1"
  if ! colmap "$@" >>"$log" 2>&1; then
    echo "align_model: colmap $1 failed; see $log" >&2
    exit 1
  fi
}

# Camera centres of the reference, -R^T t, as "name x y z" lines.
run model_converter --input_path "$reference" --output_path "$work" \
  --output_type TXT
# Every second line is one of points.
if ! awk '/^#/ { next }
     ++n % 2 && NF != 10 { for (i = 1; i < 10; ++i) sub(/^[^ ]+ /, ""); print; exit 1 }' \
  "$work/images.txt" >"$work/blank.txt"; then
  echo "align_model: $(cat "$work/blank.txt"): COLMAP's lists cannot hold names with blanks" >&2
  exit 1
fi
awk '/^#/ { next }
++n % 2 {
  w = $2; x = $3; y = $4; z = $5
  print $10,
    -((1 - 2*(y*y + z*z))*$6 + 2*(x*y + w*z)*$7 + 2*(x*z - w*y)*$8),
    -(2*(x*y - w*z)*$6 + (1 - 2*(x*x + z*z))*$7 + 2*(y*z + w*x)*$8),
    -(2*(x*z + w*y)*$6 + 2*(y*z - w*x)*$7 + (1 - 2*(x*x + y*y))*$8)
}' "$work/images.txt" >"$work/centers.txt"

# Diagonal of their bounding box.
extent=$(awk '{ for (i = 2; i < 5; ++i) {
                  if (NR == 1 || $i < low[i]) low[i] = $i
                  if (NR == 1 || $i > high[i]) high[i] = $i } }
              END { for (i = 2; i < 5; ++i) s += (high[i] - low[i]) ^ 2
                    print sqrt(s) }' "$work/centers.txt")
mkdir -p "$output"
run model_aligner --input_path "$model" \
  --output_path "$output" --ref_images_path "$work/centers.txt" \
  --ref_is_gps 0 --alignment_type custom --robust_alignment 1 \
  --robust_alignment_max_error "$(awk -v d="$extent" 'BEGIN { print d / 100 }')"
if [[ ! -f $output/images.bin ]]; then
  echo "align_model: the model could not be aligned; see $log" >&2
  exit 1
fi
