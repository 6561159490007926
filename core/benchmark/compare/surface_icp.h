// The iterative closest point method over two surfaces, with a robust loss.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/base/context.h"
#include "core/benchmark/compare/align_step.h"
#include "core/benchmark/compare/reference_filter.h"
#include "core/mesh/indexed_mesh.h"
#include "core/mesh/similarity.h"
#include "core/mesh/surface_samples.h"
#include "core/raycast/ray_scene.h"

namespace octacut {

// A mesh and the scene of it.
struct MeshWithScene {
  const IndexedMesh& mesh;
  const RayScene& scene;
};

struct IcpOptions {
  int max_iterations = 0;
  bool estimate_scale = true;
  // Ends when no point moves further in an iteration; fraction of the
  // reference's size.
  double tolerance = 0;
};

// How well the surfaces agree.
struct IcpResidual {
  // Means of both directions, in the reference's units: of the median distances
  // to the other surface, and of the root mean squares, weighted by the loss.
  double median = std::numeric_limits<double>::infinity();
  double rms = 0;
  // The share of the pairs that the loss does not reject, in the direction in
  // which it is less.
  double inliers = 0;
};

struct IcpResult {
  Similarity3d reference_from_mesh;
  IcpResidual before;
  IcpResidual after;
  int num_iterations = 0;
  bool converged = false;
};

// Pairs each sample of either surface with the closest point of the other, and
// minimises Tukey's loss of the distances along the normals (Chen & Medioni
// 1992, linearised). The loss rejects pairs beyond 4.685 standard deviations,
// which keeps 95 % of the efficiency of least squares for normal noise; the
// standard deviation is 1.4826 times the median distance, estimated anew for
// each direction in each iteration. So less than half of the pairs of either
// direction may be wrong, or of parts that one surface lacks. Both directions
// together keep the scale from collapsing.
class SurfaceIcp {
 public:
  // The references must outlive the object. Throws InputError where both are
  // clouds, which have no normals, or nothing of the reference counts.
  SurfaceIcp(const MeshWithScene& mesh,
             const MeshWithScene& reference,
             const ReferenceFilter& filter,
             int64_t num_samples,
             const Context& context);

  // The iteration with the least median.
  IcpResult Run(const Similarity3d& start,
                const IcpOptions& options,
                const Context& context) const;

  const std::vector<SurfaceSample>& MeshSamples() const {
    return mesh_samples_;
  }
  const std::vector<SurfaceSample>& ReferenceSamples() const {
    return reference_samples_;
  }

 private:
  // `pairs` are those of the iteration before, empty in the first.
  void FindPairs(const Similarity3d& reference_from_mesh,
                 const Context& context,
                 std::vector<AlignPair>* pairs) const;
  // `near`: see RayScene::ClosestPoint.
  AlignPair PairOfMesh(const SurfaceSample& sample,
                       const Similarity3d& reference_from_mesh,
                       std::optional<uint32_t> near) const;
  AlignPair PairOfReference(const SurfaceSample& sample,
                            const Similarity3d& reference_from_mesh,
                            const Similarity3d& mesh_from_reference,
                            std::optional<uint32_t> near) const;
  IcpResidual WeighPairs(std::vector<AlignPair>* pairs) const;

  const MeshWithScene mesh_;
  const MeshWithScene reference_;
  const ReferenceFilter& filter_;
  bool reference_is_cloud_;
  std::vector<SurfaceSample> mesh_samples_;
  std::vector<SurfaceSample> reference_samples_;
  Eigen::Vector3d center_;
  double size_ = 1;
};

}  // namespace octacut
