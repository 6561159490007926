#include "core/pipeline/judge_dents.h"

#include <cstdint>
#include <Eigen/LU>
#include <optional>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/pipeline/surface_agreement.h"
#include "core/raycast/ray_scene.h"

namespace octacut {
namespace {

// Width of the pixels at which views are compared, in voxels. Wider ones do not
// tell narrow folds.
constexpr double kQuarterVoxel = 0.25;
// A cut at least this many voxels behind the hull, along the line of sight, is
// judged: labels are no more precise.
constexpr double kInside = 0.5;
// Agreement about the cut less that about the hull: up to the first, a cut has
// no confidence, from the second on it has full confidence. Smaller differences
// are noise (docs/experiments/dents.md).
constexpr float kLess = -0.05f;
constexpr float kMore = 0.05f;
// A depth this many voxels behind the cut is of another surface, which may be
// right where the cut is wrong. Only where the views agree this well about the
// hull is the hull likely to be the object's surface: they agree less about the
// lids of hollows.
constexpr double kBehind = 1;
constexpr float kAgreed = 0.4f;

// A surface, and how well the views agree around its points.
class JudgedSurface {
 public:
  JudgedSurface(const ViewSet& views,
                const LabeledVoxels& surface,
                const char* phase,
                const RefineOptions& options,
                const Context& context)
      : measured_(MeasureSurface(
            views, surface, kQuarterVoxel, phase, options, context)),
        means_(measured_.agreement.MeansAround()) {
    if (!means_.empty()) {
      rays_.emplace(measured_.mesh);
    }
  }

  std::optional<RayScene::Hit> FirstHit(const Eigen::Vector3f& origin,
                                        const Eigen::Vector3f& ray) const {
    return rays_ ? rays_->FirstHit(origin.cast<double>(), ray.cast<double>())
                 : std::nullopt;
  }

  // None where it is not seen.
  std::optional<float> AgreementAt(const RayScene::Hit& hit) const {
    const uint32_t vertex = measured_.mesh.triangles[hit.triangle][0];
    const float mean = means_[measured_.agreement.points.point_of[vertex]];
    return mean == SurfaceAgreement::kUnseen ? std::nullopt
                                             : std::optional(mean);
  }

 private:
  MeasuredSurface measured_;
  std::vector<float> means_;
  std::optional<RayScene> rays_;
};

// The samples of one view. Its depths become those of the cut.
void JudgeView(const PreparedView& view,
               const JudgedSurface& hull,
               const JudgedSurface& cut,
               double voxel,
               SweptDepthMap* map,
               std::vector<float>* confidence) {
  const ViewProjection& projection = view.projection;
  const Eigen::Matrix3f rays = projection.linear.inverse();
  const std::vector<float> depths =
      std::exchange(map->depths, std::vector<float>(map->depths.size(), 0.0f));
  confidence->assign(depths.size(), 1);
  for (int y = 0; y < map->height; ++y) {
    for (int x = 0; x < map->width; ++x) {
      const Eigen::Vector3f pixel = map->Pixel(x, y);
      if (view.silhouette.SignedDistance(pixel.x(), pixel.y()) <= 0) {
        continue;
      }
      const Eigen::Vector3f ray = rays * pixel;
      const auto before = hull.FirstHit(projection.center, ray);
      const auto behind = cut.FirstHit(projection.center, ray);
      const double unit = double(ray.norm()) / voxel;
      if (!before || !behind ||
          (behind->distance - before->distance) * unit < kInside) {
        continue;
      }
      const size_t k = size_t(y) * map->width + x;
      const auto of_hull = hull.AgreementAt(*before);
      if (!of_hull ||
          (*of_hull < kAgreed &&
           (double(depths[k]) - behind->distance) * unit > kBehind)) {
        continue;
      }
      map->depths[k] = float(behind->distance);
      (*confidence)[k] =
          Ramp(cut.AgreementAt(*behind).value_or(0) - *of_hull, kLess, kMore);
    }
  }
}

}  // namespace

ReliableDepths JudgeDents(const ViewSet& views,
                          const LabeledVoxels& hull,
                          const LabeledVoxels& cut,
                          const std::vector<SweptDepthMap>& maps,
                          const RefineOptions& options,
                          const Context& context) {
  const JudgedSurface outer(
      views, hull, "dents: agreement on the hull", options, context);
  const JudgedSurface inner(
      views, cut, "dents: agreement on the cut", options, context);
  const double voxel = 1.0 / double(cut.voxels.Resolution());
  ReliableDepths judged{maps, std::vector<std::vector<float>>(maps.size())};
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      JudgeView(views[i],
                outer,
                inner,
                voxel,
                &judged.maps[i],
                &judged.confidence[i]);
    }
  });
  return judged;
}

}  // namespace octacut
