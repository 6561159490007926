#include "core/benchmark/compare/surface_icp.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <utility>

#include "core/base/error.h"
#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/mesh/cloud.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

constexpr size_t kSearchGrain = 512;
constexpr double kTukey = 4.685;

std::vector<SurfaceSample> TakeSamples(const IndexedMesh& mesh,
                                       int64_t count,
                                       uint64_t seed,
                                       const Context& context) {
  const auto num_wanted = static_cast<size_t>(count);
  return IsCloud(mesh) ? SampleCloud(mesh, num_wanted)
                       : SampleSurface(mesh, num_wanted, seed, context);
}

Eigen::Vector3d UnitNormal(const IndexedMesh& mesh, uint32_t triangle) {
  return AreaNormal(mesh, mesh.triangles[triangle]).stableNormalized();
}

// The median of the finite distances; 0 where there are none.
double MedianDistance(std::vector<AlignPair>::const_iterator begin,
                      std::vector<AlignPair>::const_iterator end) {
  std::vector<double> distances;
  for (auto pair = begin; pair != end; ++pair) {
    if (std::isfinite(pair->distance)) {
      distances.push_back(pair->distance);
    }
  }
  if (distances.empty()) {
    return 0;
  }
  return Median(std::move(distances));
}

}  // namespace

SurfaceIcp::SurfaceIcp(const MeshWithScene& mesh,
                       const MeshWithScene& reference,
                       const ReferenceFilter& filter,
                       int64_t num_samples,
                       const Context& context)
    : mesh_(mesh),
      reference_(reference),
      filter_(filter),
      reference_is_cloud_(IsCloud(reference.mesh)) {
  if (reference_is_cloud_ && IsCloud(mesh.mesh)) {
    throw InputError(
        "alignment: both are point clouds, which have no normals to align "
        "with");
  }
  mesh_samples_ =
      TakeSamples(mesh.mesh, num_samples, context.Seed() + 2, context);
  reference_samples_ =
      TakeSamples(reference.mesh, num_samples, context.Seed() + 3, context);
  if (filter_) {
    std::erase_if(reference_samples_, [&](const SurfaceSample& sample) {
      return !filter_(sample.triangle, sample.point);
    });
  }
  if (reference_samples_.empty()) {
    throw InputError(
        "alignment: no part of the reference is selected for the comparison");
  }
  Eigen::AlignedBox3d box;
  for (const SurfaceSample& sample : reference_samples_) {
    box.extend(sample.point);
  }
  center_ = box.center();
  size_ = box.diagonal().norm() / 2;
  if (!(size_ > 0)) {
    throw InputError(
        "alignment: what is selected of the reference is a single point");
  }
}

AlignPair SurfaceIcp::PairOfMesh(const SurfaceSample& sample,
                                 const Similarity3d& reference_from_mesh,
                                 std::optional<uint32_t> near) const {
  const Eigen::Vector3d moved = reference_from_mesh * sample.point;
  const RayScene::Closest closest = reference_.scene.ClosestPoint(moved, near);
  const bool counts = !filter_ || filter_(closest.triangle, closest.point);
  return {moved,
          closest.point,
          reference_is_cloud_
              ? Eigen::Vector3d(reference_from_mesh.rotation *
                                UnitNormal(mesh_.mesh, sample.triangle))
              : UnitNormal(reference_.mesh, closest.triangle),
          counts ? closest.distance : std::numeric_limits<double>::infinity(),
          0,
          closest.triangle};
}

AlignPair SurfaceIcp::PairOfReference(const SurfaceSample& sample,
                                      const Similarity3d& reference_from_mesh,
                                      const Similarity3d& mesh_from_reference,
                                      std::optional<uint32_t> near) const {
  const RayScene::Closest closest =
      mesh_.scene.ClosestPoint(mesh_from_reference * sample.point, near);
  return {reference_from_mesh * closest.point,
          sample.point,
          reference_is_cloud_
              ? Eigen::Vector3d(reference_from_mesh.rotation *
                                UnitNormal(mesh_.mesh, closest.triangle))
              : UnitNormal(reference_.mesh, sample.triangle),
          closest.distance * reference_from_mesh.scale,
          0,
          closest.triangle};
}

void SurfaceIcp::FindPairs(const Similarity3d& reference_from_mesh,
                           const Context& context,
                           std::vector<AlignPair>* pairs) const {
  const Similarity3d mesh_from_reference = reference_from_mesh.Inverse();
  const size_t num_mesh = mesh_samples_.size();
  const bool is_first = pairs->empty();
  pairs->resize(num_mesh + reference_samples_.size());
  ParallelEach(context, pairs->size(), kSearchGrain, [&](size_t i) {
    AlignPair& pair = (*pairs)[i];
    const auto near = is_first ? std::nullopt : std::optional(pair.closest);
    pair = i < num_mesh
               ? PairOfMesh(mesh_samples_[i], reference_from_mesh, near)
               : PairOfReference(reference_samples_[i - num_mesh],
                                 reference_from_mesh,
                                 mesh_from_reference,
                                 near);
  });
}

IcpResidual SurfaceIcp::WeighPairs(std::vector<AlignPair>* pairs) const {
  const auto middle =
      pairs->begin() + static_cast<std::ptrdiff_t>(mesh_samples_.size());
  IcpResidual residual;
  residual.median = 0;
  residual.inliers = 1;
  for (const auto& [begin, end] :
       {std::pair(pairs->begin(), middle), std::pair(middle, pairs->end())}) {
    const double median = MedianDistance(begin, end);
    const double limit = kTukey * kDeviationOfMedian * median;
    double sum = 0;
    double sum_of_weights = 0;
    size_t num_counted = 0;
    size_t num_inliers = 0;
    for (auto pair = begin; pair != end; ++pair) {
      // At a median of 0, only pairs of the same points are left.
      const double ratio =
          limit > 0 ? pair->distance / limit : pair->distance > 0;
      pair->weight = ratio < 1 ? (1 - ratio * ratio) * (1 - ratio * ratio) : 0;
      num_counted += std::isfinite(pair->distance);
      if (pair->weight > 0) {
        ++num_inliers;
        sum += pair->weight * pair->distance * pair->distance;
        sum_of_weights += pair->weight;
      }
    }
    residual.median += median / 2;
    residual.rms +=
        sum_of_weights > 0 ? std::sqrt(sum / sum_of_weights) / 2 : 0;
    residual.inliers =
        std::min(residual.inliers,
                 static_cast<double>(num_inliers) /
                     static_cast<double>(std::max<size_t>(num_counted, 1)));
  }
  return residual;
}

IcpResult SurfaceIcp::Run(const Similarity3d& start,
                          const IcpOptions& options,
                          const Context& context) const {
  IcpResult best;
  best.reference_from_mesh = start;
  Similarity3d current = start;
  std::vector<AlignPair> pairs;
  for (int iteration = 0; iteration <= options.max_iterations; ++iteration) {
    context.ThrowIfCancelled();
    FindPairs(current, context, &pairs);
    const IcpResidual residual = WeighPairs(&pairs);
    if (iteration == 0) {
      best.before = best.after = residual;
    } else if (residual.median < best.after.median) {
      best.after = residual;
      best.reference_from_mesh = current;
    }
    best.num_iterations = iteration;
    if (best.converged || iteration == options.max_iterations) {
      break;
    }
    const AlignStep step =
        SolveAlignStep(pairs, center_, size_, options.estimate_scale, context);
    current = step.better_from_moved * current;
    best.converged = step.largest_motion < options.tolerance;
  }
  return best;
}

}  // namespace octacut
