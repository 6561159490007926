#include "core/crust/mesh_labels.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/grid/parallel_voxels.h"
#include "core/mesh/triangle_normal.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

// Between the points of a triangle that are looked at, voxels.
constexpr double kSpacing = 0.5;

// Calls visit(point) on a grid of points of a triangle, corners included.
template <typename Visit>
void ForPointsOf(const std::array<Eigen::Vector3d, 3>& corners,
                 double spacing,
                 const Visit& visit) {
  const double longest = std::max({(corners[1] - corners[0]).norm(),
                                   (corners[2] - corners[1]).norm(),
                                   (corners[0] - corners[2]).norm()});
  const int steps = std::max(1, int(std::ceil(longest / spacing)));
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j + i <= steps; ++j) {
      visit(corners[0] + double(i) / steps * (corners[1] - corners[0]) +
            double(j) / steps * (corners[2] - corners[0]));
    }
  }
}

bool IsInside(const IndexedMesh& mesh,
              const RayScene& rays,
              const Eigen::Vector3d& point) {
  // Along no axis, face diagonal or plane of voxels, where edges of meshes
  // like to lie.
  static const Eigen::Vector3d kDirection(0.9134, 0.3771, 0.1523);
  const auto hit = rays.FirstHit(point, kDirection);
  return hit &&
         AreaNormal(mesh, mesh.triangles[hit->triangle]).dot(kDirection) > 0;
}

}  // namespace

VoxelGrid VoxelsOfMesh(const IndexedMesh& mesh, int level) {
  const double resolution = double(1u << level);
  std::vector<MortonCode> codes;
  for (const auto& triangle : mesh.triangles) {
    ForPointsOf({mesh.positions[triangle[0]],
                 mesh.positions[triangle[1]],
                 mesh.positions[triangle[2]]},
                kSpacing / resolution,
                [&](const Eigen::Vector3d& point) {
                  const Eigen::Vector3i voxel =
                      (point * resolution).array().floor().cast<int>();
                  if ((voxel.array() < 0).any() ||
                      (voxel.array() >= int(1u << level)).any()) {
                    return;
                  }
                  const MortonCode code = EncodeMorton(voxel);
                  if (codes.empty() || codes.back() != code) {
                    codes.push_back(code);
                  }
                });
  }
  return VoxelGrid::FromCodes(level, std::move(codes));
}

LabeledVoxels LabelByMesh(const IndexedMesh& mesh,
                          VoxelGrid voxels,
                          const Context& context) {
  const RayScene rays(mesh);
  LabeledVoxels result{std::move(voxels), {}};
  result.labels.assign(result.voxels.Size(), 0);
  const double size = 1.0 / result.voxels.Resolution();
  ParallelForVoxels(
      context, result.voxels, [&](VoxelGrid::Index index, MortonCode code) {
        const Eigen::Vector3d corner = size * DecodeMorton(code).cast<double>();
        for (int face = 0; face < kNumFaces; ++face) {
          // Neighbours compute the same point: sums of powers of two are exact.
          Eigen::Vector3d center = corner + Eigen::Vector3d::Constant(size / 2);
          center[face / 2] = corner[face / 2] + (face & 1) * size;
          if (IsInside(mesh, rays, center)) {
            result.labels[index] |= FaceLabels(1u << face);
          }
        }
      });
  return result;
}

}  // namespace octacut
