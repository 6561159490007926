#include "core/compare/align_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/compare/surface_samples.h"

namespace octacut {
namespace {

constexpr size_t kGrain = 512;
// Eigenvalues of the normal equations below this part of the largest belong
// to motions that the shape does not determine.
constexpr double kSmallestEigenvalue = 1e-6;
// Linearisation holds for small turns; radians and relative scale a step.
constexpr double kLargestStep = 0.2;

// A point of the moved mesh and the point of the reference it should be at.
struct Pair {
  Eigen::Vector3d moved;
  Eigen::Vector3d target;
  Eigen::Vector3d normal;  // of the reference
  double distance;         // infinite: does not count
};

using Matrix7d = Eigen::Matrix<double, 7, 7>;
using Vector7d = Eigen::Matrix<double, 7, 1>;

// Turn, shift (in units of the size) and relative scale about the centre.
struct NormalEquations {
  Matrix7d matrix = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
};

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
    mesh_samples_ = SampleSurface(mesh, count, context.Seed() + 2, context);
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
      const Vector7d step = SolveStep();
      current = ToSimilarity(step) * current;
      best.converged = step.head<3>().norm() + step.segment<3>(3).norm() +
                           std::abs(step[6]) <
                       options_.tolerance;
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
      throw InputError("reference to align with: no part of it counts");
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

  Pair PairOfMesh(const Eigen::Vector3d& moved) const {
    const RayScene::Closest closest = reference_scene_.ClosestPoint(moved);
    const bool counts = !filter_ || filter_(closest.triangle, closest.point);
    return {
        moved,
        closest.point,
        ReferenceNormal(closest.triangle),
        counts ? closest.distance : std::numeric_limits<double>::infinity()};
  }

  Pair PairOfReference(const SurfaceSample& sample,
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

  // Least squares of normal . (target - moved - motion(moved)).
  NormalEquations Accumulate() const {
    std::vector<NormalEquations> chunks(NumChunks(pairs_.size(), kGrain));
    ParallelChunks(context_,
                   pairs_.size(),
                   kGrain,
                   [&](size_t chunk, size_t begin, size_t end) {
                     for (size_t i = begin; i < end; ++i) {
                       const Pair& pair = pairs_[i];
                       if (!std::isfinite(pair.distance)) {
                         continue;
                       }
                       const Eigen::Vector3d arm =
                           (pair.moved - center_) / size_;
                       Vector7d row;
                       row << arm.cross(pair.normal), pair.normal,
                           options_.estimate_scale ? arm.dot(pair.normal) : 0.0;
                       const double residual =
                           pair.normal.dot(pair.target - pair.moved) / size_;
                       chunks[chunk].matrix += row * row.transpose();
                       chunks[chunk].right += residual * row;
                     }
                   });
    NormalEquations sum;
    for (const NormalEquations& chunk : chunks) {
      sum.matrix += chunk.matrix;
      sum.right += chunk.right;
    }
    return sum;
  }

  Vector7d SolveStep() const {
    const NormalEquations equations = Accumulate();
    const Eigen::SelfAdjointEigenSolver<Matrix7d> solver(equations.matrix);
    const double smallest = kSmallestEigenvalue * solver.eigenvalues()[6];
    Vector7d step = Vector7d::Zero();
    for (int i = 0; i < 7; ++i) {
      if (solver.eigenvalues()[i] > smallest) {
        const Vector7d direction = solver.eigenvectors().col(i);
        step += direction *
                (direction.dot(equations.right) / solver.eigenvalues()[i]);
      }
    }
    const double turn = std::max(step.head<3>().norm(), std::abs(step[6]));
    return turn > kLargestStep ? Vector7d(step * (kLargestStep / turn)) : step;
  }

  Similarity3d ToSimilarity(const Vector7d& step) const {
    const Eigen::Vector3d turn = step.head<3>();
    Similarity3d motion;
    motion.scale = 1 + step[6];
    motion.rotation = Eigen::AngleAxisd(turn.norm(), turn.stableNormalized())
                          .toRotationMatrix();
    motion.translation = center_ + size_ * step.segment<3>(3) -
                         motion.scale * (motion.rotation * center_);
    return motion;
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
  std::vector<Pair> pairs_;
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
