#include "core/verdict/removed_parts.h"

#include <opencv2/core.hpp>

#include "core/base/parallel.h"
#include "core/raycast/ray_scene.h"
#include "core/verdict/mesh_silhouette.h"

namespace octacut {

std::vector<size_t> CountPixelsOfRemoved(const IndexedMesh& removed,
                                         const ViewSet& views,
                                         const std::vector<cv::Mat>& missed,
                                         const Context& context) {
  std::vector<size_t> counts(views.size());
  if (removed.triangles.empty()) {
    return counts;
  }
  const RayScene rays(removed);
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    if (cv::countNonZero(missed[i]) > 0) {
      counts[i] =
          size_t(cv::countNonZero(RenderHits(rays, views[i]) & missed[i]));
    }
  });
  return counts;
}

}  // namespace octacut
