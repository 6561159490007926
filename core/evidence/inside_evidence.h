// Evidence for the inside and the outside at l0, where the crust is the whole
// hull and nothing says what the sink is: a view that sees a photo-consistent
// surface at some depth has seen free space before it and matter just behind.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/base/context.h"
#include "core/evidence/depth_confidence.h"
#include "core/evidence/depth_sweep.h"
#include "core/grid/voxel_grid.h"
#include "core/grid/voxel_values.h"
#include "core/views/view_set.h"

namespace octacut {

// The largest weight of any evidence; graphs hold some thousands.
inline constexpr double kMaxEvidenceWeight = 100;

// Throws OptionError unless `weight` is in 0 .. kMaxEvidenceWeight.
void CheckEvidenceWeight(std::string_view field, double weight);

struct InsideEvidenceOptions {
  DepthSweepOptions sweep;
  // Other views whose depth maps must agree (within 1.5 hull voxels) before a
  // depth counts without further question.
  int min_agreeing_views = 2;
  // A depth that fewer confirm, but one does, counts where so many of the eight
  // samples around share it and no ray to it runs through matter that better
  // confirmed depths have found; 9: never.
  int min_like_samples = 3;
  // Evidence per voxel, in units of the graph's weights. `ballooning`: what
  // each voxel of the hull has for inside, except beside a surface that a view
  // has found; unseen parts thus keep the hull. The others: the weight of one
  // view.
  double ballooning = 0.01;
  double matter_weight = 0.5;  // a view with its surface just before the voxel
  // A view that sees through the voxel, as far as its depth can be relied upon;
  // the first one counts half.
  double free_space_weight = 0.5;
  // Evidence for inside that a pixel of the object adds where a labelling
  // leaves its ray empty, spread over the hull voxels on that ray. It doubles
  // with every round until nearly all are covered, `cover_rounds` times at
  // most. Since it doubles, where it begins only changes the number of rounds.
  static constexpr double kCoverWeight = 1;
  int cover_rounds = 5;  // 0 .. 8; 0: silhouettes are not asked on any level
  void Check() const;
};

struct InsideEvidenceSummary {
  size_t num_depths = 0;       // found by the sweep
  size_t num_agreeing = 0;     // of them, confirmed by other views
  size_t num_plausible = 0;    // confirmed by too few, yet taken
  size_t num_free_voxels = 0;  // with evidence for outside
  // The share of the confirmed depths with surfaces in front of them that other
  // views have found.
  double contradicted_share = 0;
  // The share of the samples within the silhouettes that have a confirmed
  // depth.
  double found_share = 0;
};

struct InsideEvidence {
  std::vector<float> values;  // one per hull voxel; > 0 speaks for inside
  ReliableDepths depths;      // what `values` come from
  // As ConfidenceInSpace has it, of the hull before it is trimmed.
  VoxelValues depth_confidence;
  // How far photo-consistency may decide near each voxel: depth_confidence, or
  // what ReviseEvidence has made of it, which may be less or more.
  VoxelValues decision_confidence;
  bool is_mirror = false;  // as ReliableDepths has it
  // One per view, as EstimateMaskConfidence has it.
  std::vector<float> mask_confidence;
  InsideEvidenceSummary summary;
};

// What is known of a surface that was found with InsideEvidence.
struct SurfaceVerdict {
  // At samples where it is judged: its depths, and how far they can be relied
  // upon.
  ReliableDepths depths;
  // in_pit[i][k] is 1 where it lies in a pit at sample k of map i: it should
  // lie before that depth.
  std::vector<std::vector<uint8_t>> in_pit;
};

// `shown` as EstimateDepthConfidence has it.
InsideEvidence EstimateInsideEvidence(const ViewSet& views,
                                      const VoxelGrid& hull,
                                      const InsideEvidenceOptions& options,
                                      float shown,
                                      const Context& context);

// Replaces the confidence of depths at the samples where `surface`, which was
// found with them, has a depth: by the confidence of the surface times that of
// the region in the view, without that of the whole scene. `values`,
// `decision_confidence` and the number of free voxels are computed anew; in
// pits, each view adds evidence for inside as one that has found matter does.
// `surface` has maps as evidence->depths has, and `hull` the voxels of
// evidence->values. To be called once.
void ReviseEvidence(const ViewSet& views,
                    const VoxelGrid& hull,
                    const SurfaceVerdict& surface,
                    const InsideEvidenceOptions& options,
                    const Context& context,
                    InsideEvidence* evidence);

}  // namespace octacut
