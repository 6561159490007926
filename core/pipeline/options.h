// Options of a whole reconstruction: one struct per step, and what strings them
// together. Where the paper names a value, it is the default.
#pragma once

#include "core/consistency/photo_consistency.h"
#include "core/crust/crust.h"
#include "core/cut/octahedral_cut.h"
#include "core/evidence/inside_evidence.h"
#include "core/hull/visual_hull.h"
#include "core/pipeline/finish_mesh.h"
#include "core/pipeline/prepare_scene.h"
#include "core/refine/refine_options.h"
#include "core/visibility/visibility.h"

namespace octacut {

// The energy of a surface, HK06 eq. (2) and (3).
struct EnergyOptions {
  double smoothness = 4;      // s: psi(x) = x^s
  double area_weight = 1e-5;  // a
  // Evidence for outside of a voxel that is background in a view, in units of
  // the weights; and at l0 of one that is no farther from the object than
  // mask_tolerance, as far as the mask is reliable. Finer levels are held at
  // the masks' borders where photographs do not decide. Both weights: tables of
  // docs/experiments/wrong_masks.md.
  double silhouette_weight = 1;
  double mask_border_weight = 0.3;
  // Evidence for inside of a voxel of a finer level that fewer than two views
  // see, in units of the weights at l0; halved with every level. 0.15, 0.1 and
  // 0.01 are worse: docs/experiments/crusts.md.
  static constexpr double kUnseenWeight = 0.05;
  void Check() const;
};

struct ReconstructionOptions {
  MaskOptions masks;
  VisualHullOptions hull;
  InsideEvidenceOptions evidence;
  CrustOptions crust;
  VisibilityOptions visibility;
  ConsistencyOptions consistency;
  EnergyOptions energy;
  OctahedralCutOptions cut;
  FinishOptions finish;
  bool refine = true;  // the smoothed mesh, by the photographs
  RefineOptions refinement;
  int target_level = 9;  // at least hull.hull_level, at most 12
  // Times that a crust is grown where its cut touches its border, each
  // followed by another cut; 0 .. 16.
  int max_grow_rounds = 2;
  // Averagings of the inside over neighbouring voxels before its gradient is
  // taken for the normal. Not varied alone.
  static constexpr int kNormalBlur = 12;
  bool confidence = false;  // of the mesh's vertices, wanted with the verdict
  void Check() const;
};

}  // namespace octacut
