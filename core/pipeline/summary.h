// What a reconstruction tells of itself: sizes, shares and seconds of its
// steps.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/consistency/photo_consistency.h"
#include "core/evidence/inside_evidence.h"
#include "core/hull/visual_hull.h"
#include "core/pipeline/finish_mesh.h"
#include "core/refine/refine_surface.h"
#include "core/views/border_edges.h"

namespace octacut {

struct LevelSummary {
  int level = 0;
  int resolution = 0;
  size_t num_crust_voxels = 0;
  size_t num_medial_voxels = 0;
  size_t num_graph_nodes = 0;
  size_t num_cut_voxels = 0;
  double cut_cost = 0;
  ConsistencySummary consistency;
  // The share of the cut voxels where photographs decided.
  double decided_share = 0;
  int num_grow_rounds = 0;
  // Rounds in which the first level restored what silhouettes miss.
  int num_cover_rounds = 0;
  // The share of the silhouettes' sure samples that a cut left uncovered, at
  // most, and after the last one; voxels that had to be inside for them.
  double missed_before = 0;
  double missed_after = 0;
  size_t num_cover_voxels = 0;
  size_t num_border_voxels = 0;  // cut voxels that touch the crust's border
  double crust_seconds = 0;
  double visibility_seconds = 0;
  double consistency_seconds = 0;
  double cut_seconds = 0;
  double cover_seconds = 0;
};

// Cuts of the level after l0, or the next one, around its refined surface
// (BuildMesh).
struct RecutSummary {
  int num_kept = 0;
  // Each time it was asked whether to cut: the share of the vertices that
  // coarse refinement moves out of the crust.
  std::vector<double> moved;
  // Each time that was too large: the mean agreement of the photographs over
  // the refined surface.
  std::vector<double> agreements;
  double seconds = 0;
};

struct ReconstructionSummary {
  size_t num_false_gaps = 0;  // in masks, filled
  // By view: pixels by which the borders of its mask were moved inwards, singly
  // or as those of all masks; none where 0.
  std::map<std::string, double> moved_masks;
  std::optional<BorderEdges> border_edges;
  VisualHullSummary hull;
  InsideEvidenceSummary evidence;
  std::vector<LevelSummary> levels;  // of the mesh that is kept
  RecutSummary recuts;
  FinishSummary finish;
  size_t num_moved_to_hull = 0;             // vertices, MoveToHullBorder
  std::optional<RefineSummary> refinement;  // where options.refine says so
  double prepare_seconds = 0;
  double hull_agreement = 0;  // as ShownSurface has it
  double hull_seconds = 0;
  double evidence_seconds = 0;
  double meshing_seconds = 0;
  double coloring_seconds = 0;
};

}  // namespace octacut
