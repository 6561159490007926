#include "core/pipeline/level_step.h"

#include <bit>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/stopwatch.h"
#include "core/crust/medial_voxels.h"
#include "core/grid/morphology.h"
#include "core/visibility/surface_normals.h"

namespace octacut {
namespace {

constexpr size_t kBrickGrain = 64;

// phi of every voxel of `crust`. Voxels of `known` keep their `known_phi`, so
// that growing a crust costs what it adds.
std::vector<float> ExtendConsistency(const ViewSet& views,
                                     const Visibility& visibility,
                                     const VoxelGrid& known,
                                     const std::vector<float>& known_phi,
                                     const Crust& crust,
                                     const ReconstructionOptions& options,
                                     const Context& context,
                                     LevelSummary* summary) {
  Stopwatch stopwatch;
  std::vector<Eigen::Vector3f> normals = EstimateNormals(
      crust.voxels, crust.ties, crust.prior, options.normal_blur, context);
  summary->visibility_seconds += stopwatch.Lap();
  std::vector<float> phi(crust.voxels.Size());
  std::vector<uint8_t> is_new(phi.size());
  size_t num_new = 0;
  crust.voxels.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    const VoxelGrid::Index before = known.Find(code);
    is_new[index] = before == VoxelGrid::kNone;
    if (is_new[index]) {
      normals[num_new++] = normals[index];
    } else {
      phi[index] = known_phi[before];
    }
  });
  normals.resize(num_new);
  const PhotoConsistency consistency =
      EstimateConsistency(views,
                          Subset(crust.voxels, is_new),
                          normals,
                          visibility,
                          options.consistency,
                          context);
  size_t next = 0;
  for (size_t i = 0; i < phi.size(); ++i) {
    if (is_new[i]) {
      phi[i] = consistency.phi[next++];
    }
  }
  summary->consistency_seconds += stopwatch.Lap();
  summary->consistency.Add(consistency.summary);
  return phi;
}

Visibility EstimateVisibility(const ViewSet& views,
                              const VoxelGrid& surface,
                              const std::vector<FaceLabels>& labels,
                              int level,
                              const ReconstructionOptions& options,
                              const Context& context,
                              LevelSummary* summary) {
  Stopwatch stopwatch;
  Visibility visibility = Visibility::Estimate(
      views, surface, labels, level, options.visibility, context);
  summary->visibility_seconds += stopwatch.Lap();
  return visibility;
}

OctahedralCut CutCrust(const Crust& crust,
                       const std::vector<float>& phi,
                       const std::vector<float>& evidence,
                       const ReconstructionOptions& options,
                       const Context& context,
                       LevelSummary* summary) {
  Stopwatch stopwatch;
  const std::vector<float> weights = EdgeWeights(phi, options.energy);
  OctahedralCutProblem problem;
  problem.crust = &crust.voxels;
  problem.weights = weights;
  problem.ties = crust.ties;
  problem.evidence = evidence;
  OctahedralCut cut = SolveOctahedralCut(problem, options.cut, context);
  summary->cut_seconds += stopwatch.Lap();
  summary->cut_cost = cut.cost;
  summary->num_cut_voxels = cut.num_cut_voxels;
  summary->num_graph_nodes = cut.num_nodes;
  summary->num_crust_voxels = crust.voxels.Size();
  summary->num_medial_voxels = crust.num_medial_voxels;
  return cut;
}

void BeginLevel(int level, LevelSummary* summary) {
  summary->level = level;
  summary->resolution = 1 << level;
}

}  // namespace

std::vector<float> EdgeWeights(const std::vector<float>& phi,
                               const EnergyOptions& options) {
  std::vector<float> weights(phi.size());
  for (size_t i = 0; i < phi.size(); ++i) {
    weights[i] = float(std::pow(double(phi[i]), options.smoothness) +
                       options.area_weight);  // HK06 eq. (3)
  }
  return weights;
}

std::vector<float> SilhouetteEvidence(const ViewSet& views,
                                      const VoxelGrid& voxels,
                                      double weight,
                                      const Context& context) {
  std::vector<float> evidence(voxels.Size(), 0.0f);
  const float half_edge = 0.5f / float(voxels.Resolution());
  ParallelFor(context,
              voxels.Bricks().size(),
              kBrickGrain,
              [&](size_t begin, size_t end) {
                voxels.ForEachInBricks(
                    begin, end, [&](VoxelGrid::Index index, MortonCode code) {
                      const Eigen::Vector3f center =
                          VoxelCenter(DecodeMorton(code), voxels.Level());
                      for (const PreparedView& view : views) {
                        if (view.silhouette.TestCube(
                                view.projection, center, half_edge) ==
                            Footprint::kBackground) {
                          evidence[index] = -float(weight);
                          return;
                        }
                      }
                    });
              });
  return evidence;
}

LabeledVoxels SolveInitialLevel(const ViewSet& views,
                                const VoxelGrid& hull,
                                const std::vector<float>& inside_evidence,
                                const ReconstructionOptions& options,
                                const Context& context,
                                LevelSummary* summary) {
  BeginLevel(hull.Level(), summary);
  Stopwatch stopwatch;
  Crust crust = InitialCrust(hull, context);
  summary->crust_seconds += stopwatch.Lap();
  const std::vector<float> neutral(hull.Size(),
                                   float(options.consistency.neutral));
  OctahedralCut cut =
      CutCrust(crust, neutral, inside_evidence, options, context, summary);

  stopwatch.Lap();
  for (size_t i = 0; i < crust.prior.size(); ++i) {
    crust.prior[i] = float(std::popcount(cut.labels[i])) / kNumFaces;
  }
  crust.num_medial_voxels =
      TieMedialVoxels(crust.voxels, crust.prior, context, &crust.ties);
  summary->crust_seconds += stopwatch.Lap();
  const Visibility visibility = EstimateVisibility(
      views, crust.voxels, cut.labels, hull.Level(), options, context, summary);
  const std::vector<float> phi = ExtendConsistency(
      views, visibility, VoxelGrid(), {}, crust, options, context, summary);
  cut = CutCrust(crust, phi, inside_evidence, options, context, summary);
  return {std::move(crust.voxels), std::move(cut.labels)};
}

LabeledVoxels SolveFinerLevel(const ViewSet& views,
                              const LabelHierarchy& hierarchy,
                              const ReconstructionOptions& options,
                              const Context& context,
                              LevelSummary* summary) {
  BeginLevel(hierarchy.Finest().voxels.Level() + 1, summary);
  Stopwatch stopwatch;
  Crust crust = RefineCrust(hierarchy, options.crust, context);
  summary->crust_seconds += stopwatch.Lap();
  const LabeledVoxels& coarse = hierarchy.Finest();
  const Visibility visibility = EstimateVisibility(views,
                                                   coarse.voxels,
                                                   coarse.labels,
                                                   crust.voxels.Level(),
                                                   options,
                                                   context,
                                                   summary);
  VoxelGrid known;
  std::vector<float> phi;
  for (int round = 0;; ++round) {
    phi = ExtendConsistency(
        views, visibility, known, phi, crust, options, context, summary);
    stopwatch.Lap();
    const std::vector<float> evidence = SilhouetteEvidence(
        views, crust.voxels, options.energy.silhouette_weight, context);
    summary->crust_seconds += stopwatch.Lap();
    OctahedralCut cut =
        CutCrust(crust, phi, evidence, options, context, summary);
    stopwatch.Lap();
    Crust grown = GrowCrust(hierarchy,
                            crust,
                            cut.labels,
                            options.crust.crust_dilation,
                            &summary->num_border_voxels,
                            context);
    summary->crust_seconds += stopwatch.Lap();
    summary->num_grow_rounds = round;
    if (round >= options.max_grow_rounds ||
        grown.voxels.Size() == crust.voxels.Size()) {
      return {std::move(crust.voxels), std::move(cut.labels)};
    }
    known = std::move(crust.voxels);
    crust = std::move(grown);
  }
}

}  // namespace octacut
