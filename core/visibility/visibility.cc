#include "core/visibility/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check_option.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

// Map pixels that a surface voxel at the cube's centre covers, and how much a
// splat exceeds its voxel so that no ray slips between two neighbours.
constexpr float kPixelsPerVoxel = 2.0f;
constexpr float kSplatRadius = 0.6f;  // voxels

// The centres of the voxels that the surface cuts.
std::vector<Eigen::Vector3f> CutCenters(const VoxelGrid& surface,
                                        const std::vector<FaceLabels>& labels) {
  std::vector<Eigen::Vector3f> centers;
  surface.ForEach([&](VoxelGrid::Index index, MortonCode code) {
    if (IsCut(labels[index])) {
      centers.push_back(VoxelCenter(DecodeMorton(code), surface.Level()));
    }
  });
  return centers;
}

DepthMap RenderSurface(const ViewProjection& projection,
                       const std::vector<Eigen::Vector3f>& centers,
                       float voxel) {
  const float scale =
      std::min(1.0f, kPixelsPerVoxel / projection.CenterFootprint(voxel));
  DepthMap map(projection, scale);
  for (const Eigen::Vector3f& center : centers) {
    const std::optional<ProjectedPoint> p = projection.Project(center);
    if (p && p->depth > voxel) {
      map.Splat(p->u,
                p->v,
                kSplatRadius * scale * projection.Footprint(voxel, p->depth),
                p->depth);
    }
  }
  return map;
}

}  // namespace

void VisibilityOptions::Check() const {
  CheckOption(max_views >= 2 && max_views <= Visibility::kMaxViews,
              "max_views",
              max_views,
              "must be in 2 .. 16");
  CheckOption(depth_tolerance > 0,
              "depth_tolerance",
              depth_tolerance,
              "must be positive");
}

Visibility Visibility::Estimate(const ViewSet& views,
                                const VoxelGrid& surface,
                                const std::vector<FaceLabels>& labels,
                                int level,
                                const VisibilityOptions& options,
                                const Context& context) {
  options.Check();
  Visibility visibility;
  visibility.views_ = &views;
  visibility.min_cosine_ =
      float(std::cos(VisibilityOptions::kMaxAngle * std::numbers::pi / 180));
  visibility.tolerance_ = float(options.depth_tolerance / double(1 << level));
  visibility.voxel_ = 1 / float(1 << level);
  visibility.max_views_ = options.max_views;
  visibility.depth_maps_.resize(views.size());
  const std::vector<Eigen::Vector3f> centers = CutCenters(surface, labels);
  const float voxel = 1.0f / float(surface.Resolution());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    visibility.depth_maps_[i] =
        RenderSurface(views[i].projection, centers, voxel);
  });
  return visibility;
}

Visibility::Selection Visibility::Select(const Eigen::Vector3f& point,
                                         const Eigen::Vector3f& normal) const {
  Selection selection;
  if (normal.squaredNorm() == 0) {
    return selection;
  }
  // Insertion into a short sorted list of the best candidates, after the depth
  // test, so that the list holds seeing views only.
  for (size_t i = 0; i < views_->size(); ++i) {
    const Eigen::Vector3f to_camera = (*views_)[i].projection.center - point;
    const float along = normal.dot(to_camera);
    if (along <= 0) {
      continue;
    }
    const float cosine = along / to_camera.norm();
    if (cosine < min_cosine_) {
      continue;
    }
    const ViewProjection& projection = (*views_)[i].projection;
    const std::optional<ProjectedPoint> p = projection.ProjectIntoFrame(point);
    if (!p) {
      continue;
    }
    const float weight =
        cosine * std::min(1.0f, projection.Footprint(voxel_, p->depth));
    const bool full = selection.count == max_views_;
    if ((full && weight <= selection.views[selection.count - 1].weight) ||
        p->depth > depth_maps_[i].At(p->u, p->v) + tolerance_ / cosine) {
      continue;
    }
    int slot = full ? selection.count - 1 : selection.count++;
    for (; slot > 0 && selection.views[slot - 1].weight < weight; --slot) {
      selection.views[slot] = selection.views[slot - 1];
    }
    selection.views[slot] = {uint16_t(i), weight};
  }
  return selection;
}

}  // namespace octacut
