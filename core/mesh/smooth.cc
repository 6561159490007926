#include "core/mesh/smooth.h"

#include <cmath>
#include <vector>

#include "core/base/check_option.h"
#include "core/base/parallel.h"
#include "core/mesh/untangle.h"
#include "core/mesh/vertex_corners.h"

namespace octacut {
namespace {

constexpr size_t kVertexGrain = 1 << 14;

using Positions = std::vector<Eigen::Vector3d>;

// How far vertices may come from where they began.
struct Bound {
  const Positions& anchors;
  double distance;
};

// One step of HK06 step 9, V <- V + weight * Laplacian(V), within the bound.
void Step(const VertexCorners& neighbors,
          const Bound& bound,
          double weight,
          const Context& context,
          const Positions& from,
          Positions& to) {
  ParallelEach(context, from.size(), kVertexGrain, [&](size_t v) {
    const std::span<const uint32_t> around = neighbors.Of(v);
    if (around.empty()) {
      to[v] = from[v];
      return;
    }
    const Eigen::Vector3d laplacian = MeanPosition(around, from) - from[v];
    const Eigen::Vector3d moved = from[v] + weight * laplacian;
    const Eigen::Vector3d& anchor = bound.anchors[v];
    const Eigen::Vector3d displacement = moved - anchor;
    const double squared_length = displacement.squaredNorm();
    to[v] =
        squared_length > bound.distance * bound.distance
            ? anchor + bound.distance / std::sqrt(squared_length) * displacement
            : moved;
  });
}

}  // namespace

void SmoothOptions::Check() const {
  CheckOption(iterations >= 0, "iterations", iterations, "must be at least 0");
  CheckOption(taubin_mu == 0 || (taubin_mu <= -kLambda && taubin_mu >= -1.2),
              "taubin_mu",
              taubin_mu,
              "must be 0 (none) or in [-1.2, -lambda]");
  CheckOption(max_displacement >= 0 && std::isfinite(max_displacement),
              "max_displacement",
              max_displacement,
              "must be at least 0");
}

IndexedMesh SmoothSurface(IndexedMesh mesh,
                          double voxel_size,
                          const SmoothOptions& options,
                          const Context& context) {
  options.Check();
  CheckOption(voxel_size > 0, "voxel_size", voxel_size, "must be positive");
  mesh.normals.clear();
  Positions& positions = mesh.positions;
  const Positions anchors = positions;
  const double bound = options.max_displacement * voxel_size;
  {
    const VertexCorners neighbors =
        FindVertexNeighbors(positions.size(), mesh.triangles);
    Positions buffer(positions.size());
    const auto step = [&](double weight) {
      Step(neighbors, {anchors, bound}, weight, context, positions, buffer);
      positions.swap(buffer);
    };
    for (int i = 0; i < options.iterations; ++i) {
      step(SmoothOptions::kLambda);
      if (options.taubin_mu != 0) {
        step(options.taubin_mu);
      }
    }
  }
  Untangle(anchors, kMinTriangleHeight * voxel_size, context, &mesh);
  return mesh;
}

}  // namespace octacut
