# shellcheck shell=bash
# For scripts that source it: the groups of COLMAP's options for features and
# matches, which have other names since COLMAP 3.13.

# shellcheck disable=SC2034 # used by who sources this
extraction=SiftExtraction matching=SiftMatching
if colmap feature_extractor -h 2>&1 | grep -q FeatureExtraction.use_gpu; then
  # shellcheck disable=SC2034
  extraction=FeatureExtraction matching=FeatureMatching
fi
