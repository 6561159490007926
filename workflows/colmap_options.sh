# shellcheck shell=bash
# For scripts that source it: the groups of COLMAP's options for features and
# matches, which have other names since COLMAP 3.13, and the mapper's largest
# model.

# shellcheck disable=SC2034 # used by who sources this
extraction=SiftExtraction matching=SiftMatching
if colmap feature_extractor -h 2>&1 | grep -q FeatureExtraction.use_gpu; then
  # shellcheck disable=SC2034
  extraction=FeatureExtraction matching=FeatureMatching
fi

# largest_model FOLDER: the model with the most images that the mapper has made,
# as far as the size of its file tells. Prints nothing where there is none.
largest_model() {
  find "$1" -name images.bin -printf '%s %h\n' | sort -k1,1nr -k2 | sed -n '1s/^[0-9]* //p'
}
