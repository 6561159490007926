// How far a mesh is from a reference: distances between the surfaces as Metro
// measures them (Cignoni, Rocchini & Scopigno 1998), precision, recall and
// F-score (Knapitsch et al. 2017), accuracy and completeness (Seitz et al.
// 2006, "Middlebury").
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/compare/align_meshes.h"
#include "core/benchmark/compare/confidence_errors.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"

namespace octacut {

struct CompareMeshesOptions {
  int64_t num_samples = 500000;  // on each surface
  // Distances at which precision, recall and F-score are taken, in fractions of
  // the reference's diagonal.
  std::vector<double> thresholds = {0.001, 0.002, 0.005};
  // Accuracy is the distance that this fraction of the mesh keeps.
  double accuracy_fraction = 0.9;
  // Distance up to which a point counts as complete, in fractions of the
  // reference's diagonal. Middlebury's 1.25 mm are 0.6 % of the diagonal of its
  // temple.
  double completeness_threshold = 0.005;
  // Aligns the mesh with the reference first.
  bool align = false;
  AlignMeshesOptions alignment;
  ReferenceFilter reference_filter;

  // Throws OptionError.
  void Check() const;
};

// Distances of the points of one surface to the closest ones of the other, in
// the reference's units.
struct DistanceStatistics {
  size_t num_samples = 0;  // that count
  // Over the samples, so area-weighted.
  double mean = 0;
  double rms = 0;
  double median = 0;
  double percentile_90 = 0;
  // Over the samples and the vertices: one side of the Hausdorff distance.
  double max = 0;
};

struct ThresholdScore {
  double threshold = 0;  // fraction of the reference's diagonal
  double distance = 0;   // the same in the reference's units
  double precision = 0;  // fraction of the mesh within the distance
  double recall = 0;     // fraction of the reference within the distance
  double f_score = 0;    // harmonic mean of both; 0 where both are
};

struct MeshComparison {
  // The diagonal of the bounding box of the reference's triangles.
  double reference_diagonal = 0;
  // The fraction of the reference's area that counts, measured by its samples.
  double judged_share = 1;
  DistanceStatistics to_reference;    // from the mesh
  DistanceStatistics from_reference;  // to the mesh
  std::vector<ThresholdScore> scores;
  // Precision and recall over all thresholds of distance_curve.h.
  std::vector<double> precision_curve;
  std::vector<double> recall_curve;
  double accuracy = 0;      // a distance
  double completeness = 0;  // a fraction of the reference
  std::optional<MeshAlignment> alignment;
  // Where the mesh has a confidence.
  std::optional<ConfidenceErrors> confidence;

  double Hausdorff() const {
    return std::max(to_reference.max, from_reference.max);
  }
};

// Both meshes may be open or not manifold; vertices that no triangle uses do
// not count. Either may be a point cloud (no triangles): its points are the
// samples, num_samples at most, and each stands for itself. The samples depend
// on Context::Seed() alone: the same bytes for any number of threads. Throws
// InputError when a mesh is empty, has no area or an index out of range, when
// nothing of the reference counts, or when it is a cloud and `align` asks for
// its normals.
MeshComparison CompareMeshes(const IndexedMesh& mesh,
                             const IndexedMesh& reference,
                             const CompareMeshesOptions& options,
                             const Context& context);

}  // namespace octacut
