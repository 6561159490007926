#include "core/verdict/judge_mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/stopwatch.h"
#include "core/raycast/ray_scene.h"
#include "core/raycast/unit_mesh.h"
#include "core/verdict/confidence.h"
#include "core/verdict/removed_parts.h"

namespace octacut {
namespace {

// Between the points where the photographs are compared, pixels: patches of
// seven beside each other nearly touch.
constexpr double kSpacing = 6;
// The same where each vertex is asked about.
constexpr double kFineSpacing = 4;

std::vector<MaskUncertainty> UncertaintiesOf(const std::vector<View>& views,
                                             const JudgeOptions& options) {
  std::vector<MaskUncertainty> uncertainties;
  uncertainties.reserve(views.size());
  for (size_t i = 0; i < views.size(); ++i) {
    const double tolerance = options.mask_tolerance * views[i].scale;
    const double moved =
        options.moved_inwards.empty() ? 0 : options.moved_inwards[i];
    uncertainties.push_back(
        {.given = UncertaintyOfBorders(options.border_shift + moved, tolerance),
         .repaired = UncertaintyOfBorders(options.border_shift, tolerance)});
  }
  return uncertainties;
}

bool HaveImages(const ViewSet& views) {
  return std::all_of(views.begin(), views.end(), [](const PreparedView& view) {
    return view.pyramid.NumLevels() > 0;
  });
}

// The missed pixels that lie no deeper in their mask than half of three voxels
// of the hull.
size_t CountThinPixels(const ViewSet& views,
                       const std::vector<cv::Mat>& missed,
                       int hull_level) {
  constexpr float kThinVoxels = 3;
  size_t count = 0;
  for (size_t i = 0; i < views.size(); ++i) {
    const float depth =
        kThinVoxels / 2 *
        views[i].projection.CenterFootprint(1.0f / float(1 << hull_level));
    for (int y = 0; y < missed[i].rows; ++y) {
      for (int x = 0; x < missed[i].cols; ++x) {
        count += missed[i].at<uint8_t>(y, x) != 0 &&
                 views[i].silhouette.SignedDistance(float(x) + 0.5f,
                                                    float(y) + 0.5f) <= depth;
      }
    }
  }
  return count;
}

// What the photographs say of `unit`, and rays of it.
RayScene JudgeSurface(const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context,
                      IndexedMesh* unit,
                      MeshVerdict* verdict) {
  if (!HaveImages(scene.views)) {
    return RayScene(*unit);
  }
  SurfaceEvidence evidence = MeasureSurfaceEvidence(
      scene.views,
      {.refinement = options.refinement,
       .spacing = options.confidence ? kFineSpacing : kSpacing,
       .border_shift = options.border_shift},
      context,
      unit);
  verdict->surface = SumUpSupport(evidence.values, scene.given, scene.views);
  if (options.confidence) {
    verdict->confidence = VertexConfidence(*unit, evidence, context);
  }
  return std::move(evidence.rays);
}

// What the masks say of the mesh that `rays` hit, and of what was `removed`.
void JudgeSilhouettes(const RayScene& rays,
                      const IndexedMesh& removed,
                      const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context,
                      MeshVerdict* verdict) {
  SilhouetteCheck check =
      CheckSilhouettes(rays,
                       scene.given,
                       scene.repaired,
                       scene.views,
                       UncertaintiesOf(scene.given, options),
                       context);
  verdict->removed_pixels = CountPixelsOfRemoved(
      UnitMesh(removed, scene.cube), scene.views, check.missed, context);
  if (options.hull_level > 0) {
    verdict->num_thin_pixels =
        CountThinPixels(scene.views, check.missed, options.hull_level);
  }
  verdict->given_masks = std::move(check.given);
  verdict->repaired_masks = std::move(check.repaired);
}

}  // namespace

MeshVerdict JudgeMesh(const IndexedMesh& mesh,
                      const IndexedMesh& removed,
                      const JudgedScene& scene,
                      const JudgeOptions& options,
                      const Context& context) {
  MeshVerdict verdict;
  verdict.border_shift = options.border_shift;
  verdict.hull_level = options.hull_level;
  IndexedMesh unit = UnitMesh(mesh, scene.cube);
  const RayScene rays = Timed(&verdict.surface_seconds, [&] {
    return JudgeSurface(scene, options, context, &unit, &verdict);
  });
  Timed(&verdict.silhouette_seconds, [&] {
    JudgeSilhouettes(rays, removed, scene, options, context, &verdict);
  });
  return verdict;
}

}  // namespace octacut
