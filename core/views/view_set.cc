#include "core/views/view_set.h"

#include "core/base/parallel.h"

namespace octacut {

ViewSet PrepareViews(const Scene& scene,
                     const BoundingCube& cube,
                     const Context& context,
                     double mask_tolerance) {
  ViewSet views(scene.views.size());
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    const View& view = scene.views[i];
    views[i].projection = MakeViewProjection(view, cube);
    views[i].silhouette = Silhouette(view.mask, view.unknown);
    views[i].mask_tolerance = float(mask_tolerance * view.scale);
    if (!view.image.empty()) {
      views[i].pyramid = ImagePyramid(view.image, view.mask);
    }
  });
  return views;
}

std::vector<ViewProjection> Projections(const ViewSet& views) {
  std::vector<ViewProjection> projections;
  for (const PreparedView& view : views) {
    projections.push_back(view.projection);
  }
  return projections;
}

void SetProjections(const std::vector<ViewProjection>& projections,
                    ViewSet* views) {
  for (size_t i = 0; i < projections.size(); ++i) {
    (*views)[i].projection = projections[i];
  }
}

double PixelSize(const ViewSet& views, const Eigen::Vector3f& point) {
  double pixels = 0;
  double squares = 0;
  for (const PreparedView& view : views) {
    const float depth = view.projection.Homogeneous(point).z();
    if (depth > 0) {
      const double pixels_per_unit = view.projection.Footprint(1, depth);
      pixels += pixels_per_unit;
      squares += pixels_per_unit * pixels_per_unit;
    }
  }
  return squares > 0 ? pixels / squares : 0;
}

size_t EstimateViewBytes(const Scene& scene) {
  size_t bytes = 0;
  for (const View& view : scene.views) {
    // Pyramid (4 bytes per pixel and a third), distances to borders of masks
    // and edges, depths of the surface.
    bytes += view.mask.total() * 14;
  }
  return bytes;
}

}  // namespace octacut
