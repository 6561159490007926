#include "core/pipeline/hull_border.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>
#include <optional>

#include "core/base/parallel.h"
#include "core/evidence/mask_confidence.h"
#include "core/mesh/normals.h"
#include "core/mesh/untangle.h"

namespace octacut {
namespace {

constexpr size_t kBorderGrain = 1024;
// The least cosine between a normal and the direction to the border: a surface
// that is turned farther only passes through the border.
constexpr float kLeastSlope = 0.5f;

// Standard deviations: of the border of a mask, in pixels, and of the cut, in
// voxels. Where photographs decide, the cut is the right one of the voxels, and
// its error is uniform over one.
constexpr float kBorderError = 0.5f;
constexpr float kDecidedError = 0.29f;
constexpr float kUndecidedError = 0.5;

// How deep a point of the surface lies in the hull.
struct DepthInHull {
  float depth = Silhouette::kFarInside;  // unit coordinates; < 0 outside
  float pixel = 0;  // of the view with the nearest border, unit coordinates
};

// A vertex near the border.
struct NearBorder {
  float depth = 0;  // along the normal, voxels or pixels, the larger of both
  float unit = 0;   // the larger of both, unit coordinates; 0: not near
  float pixel = 0;  // in those units
};

class HullBorder {
 public:
  HullBorder(const SilhouetteHull& hull, float voxel) : voxel_(voxel) {
    for (size_t i = 0; i < hull.views.size(); ++i) {
      if (hull.mask_confidence[i] > kReliableMask) {
        views_.push_back(&hull.views[i]);
      }
    }
  }

  NearBorder Find(const Eigen::Vector3f& point,
                  const Eigen::Vector3f& normal) const {
    const DepthInHull here = Depth(point);
    const float unit = std::max(voxel_, here.pixel);
    if (std::abs(here.depth) >= kFarthest * unit) {
      return {};
    }
    const Eigen::Vector3f step = 0.5f * unit * normal;
    const float slope =
        (Depth(point - step).depth - Depth(point + step).depth) / unit;
    if (slope < kLeastSlope) {
      return {};
    }
    return {here.depth / (slope * unit), unit, here.pixel / unit};
  }

  static constexpr float kFarthest = 4;

 private:
  DepthInHull Depth(const Eigen::Vector3f& point) const {
    DepthInHull least;
    for (const PreparedView* view : views_) {
      const std::optional<ProjectedPoint> p =
          view->projection.ProjectIntoFrame(point);
      if (!p) {
        continue;
      }
      const float pixel = 1 / view->projection.Footprint(1, p->depth);
      const float depth = view->DistanceInside(*p) * pixel;
      if (depth < least.depth) {
        least = {depth, pixel};
      }
    }
    return least;
  }

  float voxel_;
  std::vector<const PreparedView*> views_;
};

// How likely what is so deep in the hull lies on its border: surfaces inside of
// it have any depth.
class BorderChance {
 public:
  explicit BorderChance(const std::vector<NearBorder>& vertices) {
    for (const NearBorder& vertex : vertices) {
      if (vertex.unit > 0 && std::abs(vertex.depth) < HullBorder::kFarthest) {
        ++counts_[Bin(vertex.depth)];
      }
    }
    const int first = Bin(kInside);
    for (int bin = first; bin < kNumBins; ++bin) {
      inside_ += float(counts_[bin]) / float(kNumBins - first);
    }
  }

  float Of(float depth) const {
    const float count = float(counts_[Bin(depth)]);
    return count > inside_ ? 1 - inside_ / count : 0;
  }

 private:
  static constexpr int kBinsAUnit = 4;
  static constexpr int kNumBins = int(2 * HullBorder::kFarthest) * kBinsAUnit;
  // Surfaces that are deeper are not the border's.
  static constexpr float kInside = 2;

  static int Bin(float depth) {
    return std::clamp(int(float(kBinsAUnit) * (depth + HullBorder::kFarthest)),
                      0,
                      kNumBins - 1);
  }

  std::array<size_t, kNumBins> counts_ = {};
  float inside_ = 0;
};

// The value of the voxel that holds a point of the surface. 1 where there is
// none: then the point moves least.
float DecidedAt(const DecidedVoxels& decided, const Eigen::Vector3f& point) {
  const VoxelGrid::Index index = decided.voxels.FindAt(point);
  return index == VoxelGrid::kNone ? 1 : decided.decided[index];
}

}  // namespace

size_t MoveToHullBorder(const SilhouetteHull& hull,
                        const DecidedVoxels& decided,
                        const Context& context,
                        IndexedMesh* mesh) {
  const BoundingCube& cube = hull.cube;
  const float voxel = 1.0f / float(decided.voxels.Resolution());
  const HullBorder border(hull, voxel);
  const std::vector<Eigen::Vector3d> before = mesh->positions;
  std::vector<NearBorder> vertices(before.size());
  const auto unit_point = [&](size_t v) -> Eigen::Vector3f {
    return cube.ToUnit(before[v]).cast<float>();
  };
  ParallelEach(context, before.size(), kBorderGrain, [&](size_t v) {
    vertices[v] = border.Find(unit_point(v), mesh->normals[v]);
  });
  const BorderChance chance(vertices);
  ParallelEach(context, before.size(), kBorderGrain, [&](size_t v) {
    const NearBorder& vertex = vertices[v];
    if (vertex.unit == 0 || std::abs(vertex.depth) >= 1) {
      return;
    }
    const float share = DecidedAt(decided, unit_point(v));
    const float cut_error =
        (kUndecidedError + share * (kDecidedError - kUndecidedError)) * voxel /
        vertex.unit;
    const float border_error = kBorderError * vertex.pixel;
    const float move =
        chance.Of(vertex.depth) * vertex.depth * vertex.unit /
        (1 + border_error * border_error / (cut_error * cut_error));
    if (move != 0) {
      mesh->positions[v] = RoundedToFloats(
          before[v] + cube.edge * (move * mesh->normals[v]).cast<double>());
    }
  });
  UntangleFloats(before,
                 kMinTriangleHeight * cube.VoxelSize(decided.voxels.Level()),
                 context,
                 mesh);
  mesh->normals = ComputeVertexNormals(*mesh, context);
  size_t num_moved = 0;
  for (size_t v = 0; v < before.size(); ++v) {
    num_moved += mesh->positions[v] != before[v];
  }
  return num_moved;
}

}  // namespace octacut
