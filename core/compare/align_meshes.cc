#include "core/compare/align_meshes.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/compare/align_step.h"
#include "core/compare/cloud.h"
#include "core/compare/surface_samples.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 512;

class Aligner {
 public:
  Aligner(const IndexedMesh& mesh,
          const RayScene& mesh_scene,
          const IndexedMesh& reference,
          const RayScene& reference_scene,
          const AlignMeshesOptions& options,
          const Context& context,
          const ReferenceFilter& filter)
      : mesh_scene_(mesh_scene),
        reference_(reference),
        reference_scene_(reference_scene),
        options_(options),
        context_(context),
        filter_(filter) {
    const auto count = static_cast<size_t>(options.num_samples);
    if (IsCloud(reference)) {
      throw InputError(
          "alignment: the reference is a point cloud, which has no normals to "
          "align with");
    }
    mesh_samples_ =
        IsCloud(mesh) ? SampleCloud(mesh, count)
                      : SampleSurface(mesh, count, context.Seed() + 2, context);
    reference_samples_ =
        SampleSurface(reference, count, context.Seed() + 3, context);
    DropFilteredSamples();
    Eigen::AlignedBox3d box;
    for (const SurfaceSample& sample : reference_samples_) {
      box.extend(sample.point);
    }
    center_ = box.center();
    size_ = box.diagonal().norm() / 2;
  }

  MeshAlignment Run() {
    Phase phase(
        context_, "Align", static_cast<size_t>(options_.max_iterations));
    MeshAlignment best;
    Similarity3d current;
    for (int iteration = 0; iteration <= options_.max_iterations; ++iteration) {
      FindPairs(current);
      const double rms = TrimPairs();
      if (iteration == 0) {
        best.rms_before = best.rms_after = rms;
      } else if (rms < best.rms_after) {
        best.rms_after = rms;
        best.reference_from_mesh = current;
      }
      best.num_iterations = iteration;
      if (best.converged || iteration == options_.max_iterations) {
        break;
      }
      const AlignStep step = SolveAlignStep(
          pairs_, center_, size_, options_.estimate_scale, context_);
      current = step.better_from_moved * current;
      best.converged = step.largest_motion < options_.tolerance;
      phase.Advance();
    }
    return best;
  }

 private:
  void DropFilteredSamples() {
    if (filter_) {
      std::erase_if(reference_samples_, [&](const SurfaceSample& sample) {
        return !filter_(sample.triangle, sample.point);
      });
    }
    if (reference_samples_.empty()) {
      throw InputError(
          "alignment: no part of the reference is selected for the comparison");
    }
  }

  Eigen::Vector3d ReferenceNormal(uint32_t triangle) const {
    const auto& [a, b, c] = reference_.triangles[triangle];
    const Eigen::Vector3d& origin = reference_.positions[a];
    return (reference_.positions[b] - origin)
        .cross(reference_.positions[c] - origin)
        .stableNormalized();
  }

  void FindPairs(const Similarity3d& reference_from_mesh) {
    const Similarity3d mesh_from_reference = reference_from_mesh.Inverse();
    pairs_.resize(mesh_samples_.size() + reference_samples_.size());
    ParallelFor(context_, pairs_.size(), kGrain, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        pairs_[i] =
            i < mesh_samples_.size()
                ? PairOfMesh(reference_from_mesh * mesh_samples_[i].point)
                : PairOfReference(reference_samples_[i - mesh_samples_.size()],
                                  reference_from_mesh,
                                  mesh_from_reference);
      }
    });
  }

  AlignPair PairOfMesh(const Eigen::Vector3d& moved) const {
    const RayScene::Closest closest = reference_scene_.ClosestPoint(moved);
    const bool counts = !filter_ || filter_(closest.triangle, closest.point);
    return {
        moved,
        closest.point,
        ReferenceNormal(closest.triangle),
        counts ? closest.distance : std::numeric_limits<double>::infinity()};
  }

  AlignPair PairOfReference(const SurfaceSample& sample,
                            const Similarity3d& reference_from_mesh,
                            const Similarity3d& mesh_from_reference) const {
    const RayScene::Closest closest =
        mesh_scene_.ClosestPoint(mesh_from_reference * sample.point);
    return {reference_from_mesh * closest.point,
            sample.point,
            ReferenceNormal(sample.triangle),
            closest.distance * reference_from_mesh.scale};
  }

  // Marks the pairs beyond the kept fraction of their direction, and returns
  // the root mean square of the distances of the others.
  double TrimPairs() {
    double sum = 0;
    size_t count = 0;
    const auto middle =
        pairs_.begin() + static_cast<std::ptrdiff_t>(mesh_samples_.size());
    for (const auto& [begin, end] :
         {std::pair(pairs_.begin(), middle), std::pair(middle, pairs_.end())}) {
      std::vector<double> distances;
      for (auto pair = begin; pair != end; ++pair) {
        if (std::isfinite(pair->distance)) {
          distances.push_back(pair->distance);
        }
      }
      if (distances.empty()) {
        continue;
      }
      const auto last =
          distances.begin() + static_cast<std::ptrdiff_t>(
                                  options_.kept_fraction *
                                  static_cast<double>(distances.size() - 1));
      std::nth_element(distances.begin(), last, distances.end());
      const double limit = *last;
      for (auto pair = begin; pair != end; ++pair) {
        if (pair->distance <= limit) {
          sum += pair->distance * pair->distance;
          ++count;
        } else {
          pair->distance = std::numeric_limits<double>::infinity();
        }
      }
    }
    return std::sqrt(sum / static_cast<double>(std::max<size_t>(count, 1)));
  }

  const RayScene& mesh_scene_;
  const IndexedMesh& reference_;
  const RayScene& reference_scene_;
  const AlignMeshesOptions& options_;
  const Context& context_;
  const ReferenceFilter& filter_;
  std::vector<SurfaceSample> mesh_samples_;
  std::vector<SurfaceSample> reference_samples_;
  Eigen::Vector3d center_;
  double size_ = 1;
  std::vector<AlignPair> pairs_;
};

}  // namespace

void AlignMeshesOptions::Check() const {
  CheckOption(num_samples >= 10 && num_samples <= int64_t{100'000'000},
              "alignment.num_samples",
              num_samples,
              "must be from 10 to 100000000");
  CheckOption(max_iterations >= 1,
              "alignment.max_iterations",
              max_iterations,
              "must be positive");
  CheckOption(kept_fraction > 0 && kept_fraction <= 1,
              "alignment.kept_fraction",
              kept_fraction,
              "must be in (0, 1]");
  CheckOption(
      tolerance >= 0, "alignment.tolerance", tolerance, "must not be negative");
}

MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const IndexedMesh& reference,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter) {
  return AlignMeshes(mesh,
                     RayScene(mesh),
                     reference,
                     RayScene(reference),
                     options,
                     context,
                     filter);
}

MeshAlignment AlignMeshes(const IndexedMesh& mesh,
                          const RayScene& mesh_scene,
                          const IndexedMesh& reference,
                          const RayScene& reference_scene,
                          const AlignMeshesOptions& options,
                          const Context& context,
                          const ReferenceFilter& filter) {
  options.Check();
  return Aligner(mesh,
                 mesh_scene,
                 reference,
                 reference_scene,
                 options,
                 context,
                 filter)
      .Run();
}

}  // namespace octacut
