#include "core/benchmark/compare/global_alignment.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/mesh/cloud.h"
#include "core/mesh/cluster_vertices.h"

namespace octacut {
namespace {

constexpr double kPi = std::numbers::pi;

// One stage: how many of the candidates of the stage before go on, with how
// many samples on each surface and how many iterations.
struct Stage {
  size_t num_candidates;
  int64_t num_samples;
  int num_iterations;
  bool is_coarse;  // on reduced surfaces
};
// 600 rotations are some 25 degrees from their neighbours, so that none is
// more than 20 degrees off, from where ICP finds the way for most shapes.
// Samples suffice to tell the right rotation (20 points would determine it);
// the last stage is as fine as needed to tell symmetric solutions apart.
constexpr Stage kStages[] = {
    {600, 150, 8, true}, {60, 400, 20, true}, {4, 2000, 25, false}};
// Triangles or points of a reduced surface: details of 1 % of its size, which
// is finer than the search, in a tree that fits into the cache.
constexpr size_t kReducedSize = 10000;

// Two solutions are the same where no point of the reference moves further from
// one to the other, as a fraction of its size.
constexpr double kSameSolution = 0.05;

// What counts of a surface, reduced.
IndexedMesh ReduceSurface(const IndexedMesh& mesh,
                          const ReferenceFilter& filter,
                          const Context& context) {
  IndexedMesh reduced;
  reduced.positions = mesh.positions;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Eigen::Vector3d center =
        (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
    if (!filter || filter(i, center)) {
      reduced.triangles.push_back(mesh.triangles[i]);
    }
  }
  if (!IsCloud(mesh) && !reduced.triangles.empty()) {
    return ClusterVertices(reduced, kReducedSize, context).mesh;
  }
  IndexedMesh points;
  const size_t total = reduced.triangles.size();
  for (size_t i = 0; i < std::min(kReducedSize, total); ++i) {
    const size_t from = i * total / std::min(kReducedSize, total);
    points.positions.push_back(mesh.positions[reduced.triangles[from][0]]);
  }
  return PointsAsTriangles(std::move(points));
}

struct Candidate {
  Similarity3d reference_from_mesh;
  double median = 0;
};

// The i-th of `count` rotations.
Eigen::Matrix3d SpiralRotation(size_t i, size_t count) {
  // Alexa's constants: phi is the square root of 2, psi solves psi^4 = psi + 4.
  constexpr double kPhi = 1.41421356237309505;
  constexpr double kPsi = 1.533751168755204288118041;
  const double s = static_cast<double>(i) + 0.5;
  const double r = std::sqrt(s / static_cast<double>(count));
  const double big_r = std::sqrt(1 - s / static_cast<double>(count));
  const double alpha = 2 * kPi * s / kPhi;
  const double beta = 2 * kPi * s / kPsi;
  return Eigen::Quaterniond(big_r * std::cos(beta),
                            r * std::sin(alpha),
                            r * std::cos(alpha),
                            big_r * std::sin(beta))
      .toRotationMatrix();
}

// The mean position, and the median distance to it.
struct Spread {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0;
};

Spread SpreadOf(const std::vector<SurfaceSample>& samples) {
  Spread spread;
  // Weiszfeld's iteration for the geometric median: wrong parts elsewhere move
  // it less than the mean.
  for (const SurfaceSample& sample : samples) {
    spread.center += sample.point / static_cast<double>(samples.size());
  }
  std::vector<double> distances(samples.size());
  for (int iteration = 0; iteration < 50; ++iteration) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double sum_of_weights = 0;
    for (size_t i = 0; i < samples.size(); ++i) {
      distances[i] = (samples[i].point - spread.center).norm();
      if (distances[i] > 0) {
        sum += samples[i].point / distances[i];
        sum_of_weights += 1 / distances[i];
      }
    }
    spread.radius = Median(distances);
    if (sum_of_weights > 0) {
      spread.center = sum / sum_of_weights;
    }
  }
  return spread;
}

std::vector<Candidate> Starts(const SurfaceIcp& icp,
                              bool estimate_scale,
                              size_t count) {
  const Spread mesh = SpreadOf(icp.MeshSamples());
  const Spread reference = SpreadOf(icp.ReferenceSamples());
  std::vector<Candidate> starts(count);
  for (size_t i = 0; i < count; ++i) {
    Similarity3d& start = starts[i].reference_from_mesh;
    start.scale = estimate_scale && mesh.radius > 0 && reference.radius > 0
                      ? reference.radius / mesh.radius
                      : 1;
    start.rotation = SpiralRotation(i, count);
    start.translation =
        reference.center - start.scale * (start.rotation * mesh.center);
  }
  return starts;
}

bool AreSame(const Similarity3d& a,
             const Similarity3d& b,
             const SurfaceIcp& icp,
             double size) {
  return std::all_of(icp.MeshSamples().begin(),
                     icp.MeshSamples().end(),
                     [&](const SurfaceSample& sample) {
                       return (a * sample.point - b * sample.point).norm() <=
                              kSameSolution * size;
                     });
}

// Moves each candidate to where ICP leads from it, and sorts them.
void RunIcpFromAll(const SurfaceIcp& icp,
                   const Stage& stage,
                   bool estimate_scale,
                   const Context& context,
                   Phase* phase,
                   std::vector<Candidate>* candidates) {
  IcpOptions options;
  options.max_iterations = stage.num_iterations;
  options.estimate_scale = estimate_scale;
  options.tolerance = 1e-4;
  ParallelFor(context, candidates->size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      Candidate& candidate = (*candidates)[i];
      const IcpResult aligned =
          icp.Run(candidate.reference_from_mesh, options, context);
      candidate = {aligned.reference_from_mesh, aligned.after.median};
    }
    phase->Advance(end - begin);
  });
  std::stable_sort(candidates->begin(),
                   candidates->end(),
                   [](const Candidate& a, const Candidate& b) {
                     return a.median < b.median;
                   });
}

// Many rotations lead to the same solution: the first of each.
std::vector<Candidate> KeepDistinct(const std::vector<Candidate>& candidates,
                                    const SurfaceIcp& icp) {
  const double size = 2 * SpreadOf(icp.ReferenceSamples()).radius;
  std::vector<Candidate> distinct;
  for (const Candidate& candidate : candidates) {
    const bool is_new = std::none_of(
        distinct.begin(), distinct.end(), [&](const Candidate& other) {
          return AreSame(candidate.reference_from_mesh,
                         other.reference_from_mesh,
                         icp,
                         size);
        });
    if (is_new) {
      distinct.push_back(candidate);
    }
  }
  return distinct;
}

}  // namespace

GlobalAlignment FindGlobalAlignment(const MeshWithScene& mesh,
                                    const MeshWithScene& reference,
                                    const ReferenceFilter& filter,
                                    bool estimate_scale,
                                    const Context& context) {
  size_t total = 0;
  for (const Stage& stage : kStages) {
    total += stage.num_candidates;
  }
  const IndexedMesh coarse_mesh = ReduceSurface(mesh.mesh, {}, context);
  const IndexedMesh coarse_reference =
      ReduceSurface(reference.mesh, filter, context);
  if (coarse_reference.triangles.empty()) {
    throw InputError(
        "alignment: no part of the reference is selected for the comparison");
  }
  const RayScene coarse_mesh_scene(coarse_mesh);
  const RayScene coarse_reference_scene(coarse_reference);
  const ReferenceFilter all;
  Phase phase(context, "search for the alignment", total);
  std::vector<Candidate> candidates;
  GlobalAlignment result;
  for (const Stage& stage : kStages) {
    const SurfaceIcp icp =
        stage.is_coarse
            ? SurfaceIcp({coarse_mesh, coarse_mesh_scene},
                         {coarse_reference, coarse_reference_scene},
                         all,
                         stage.num_samples,
                         context)
            : SurfaceIcp(mesh, reference, filter, stage.num_samples, context);
    if (candidates.empty()) {
      candidates = Starts(icp, estimate_scale, stage.num_candidates);
    }
    candidates.resize(std::min(candidates.size(), stage.num_candidates));
    RunIcpFromAll(icp, stage, estimate_scale, context, &phase, &candidates);
    candidates = KeepDistinct(candidates, icp);
    result.reference_from_mesh = candidates[0].reference_from_mesh;
    result.median = candidates[0].median;
    result.next_median = candidates.size() > 1
                             ? candidates[1].median
                             : std::numeric_limits<double>::infinity();
  }
  return result;
}

}  // namespace octacut
