#include "core/pipeline/judge_dents.h"

#include <algorithm>
#include <cstddef>
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
// Standard deviation of the brightness in which the views see a point of the
// hull, grey levels, median over what has no detail: up to the first, the
// surface is matt, and its shading tells where it is; from the second on, it is
// not (docs/experiments/dents.md).
constexpr float kEvenBrightness = 1;
constexpr float kChangingBrightness = 2;
// Of the samples along a row or a column, one in so many is asked for that.
constexpr int kBrightnessStep = 3;
constexpr float kHalfDetail = 0.5f;

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
    const float mean = means_[PointOf(hit)];
    return mean == SurfaceAgreement::kUnseen ? std::nullopt
                                             : std::optional(mean);
  }

  // As SurfaceAgreement has it; none where it is not seen.
  std::optional<float> BrightnessDeviationAt(const RayScene::Hit& hit) const {
    const SurfaceAgreement& agreement = measured_.agreement;
    const uint32_t point = PointOf(hit);
    return agreement.is_seen[point]
               ? std::optional(agreement.brightness_deviations[point])
               : std::nullopt;
  }

 private:
  uint32_t PointOf(const RayScene::Hit& hit) const {
    const uint32_t vertex = measured_.mesh.triangles[hit.triangle][0];
    return measured_.agreement.points.point_of[vertex];
  }

  MeasuredSurface measured_;
  std::vector<float> means_;
  std::optional<RayScene> rays_;
};

// Appends the deviations that points of the hull have which a view shows
// without detail.
void AppendDeviations(const PreparedView& view,
                      const SweptDepthMap& map,
                      const JudgedSurface& hull,
                      std::vector<float>* deviations) {
  const ViewProjection& projection = view.projection;
  const Eigen::Matrix3f rays = projection.linear.inverse();
  for (int y = 0; y < map.height; y += kBrightnessStep) {
    for (int x = 0; x < map.width; x += kBrightnessStep) {
      const Eigen::Vector3f pixel = map.Pixel(x, y);
      if (map.detail[size_t(y) * map.width + x] >= kHalfDetail ||
          view.silhouette.SignedDistance(pixel.x(), pixel.y()) <= 0) {
        continue;
      }
      const auto hit = hull.FirstHit(projection.center, rays * pixel);
      const auto deviation =
          hit ? hull.BrightnessDeviationAt(*hit) : std::nullopt;
      if (deviation) {
        deviations->push_back(*deviation);
      }
    }
  }
}

// How far what has no detail scatters light evenly, 0 .. 1; 1 where everything
// has detail.
float Mattness(const ViewSet& views,
               const std::vector<SweptDepthMap>& maps,
               const JudgedSurface& hull,
               const Context& context) {
  std::vector<std::vector<float>> of_views(maps.size());
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      AppendDeviations(views[i], maps[i], hull, &of_views[i]);
    }
  });
  std::vector<float> deviations;
  for (const std::vector<float>& of_view : of_views) {
    deviations.insert(deviations.end(), of_view.begin(), of_view.end());
  }
  if (deviations.empty()) {
    return 1;
  }
  const auto median = deviations.begin() + ptrdiff_t(deviations.size() / 2);
  std::nth_element(deviations.begin(), median, deviations.end());
  return Ramp(*median, kChangingBrightness, kEvenBrightness);
}

// What the samples of a view are judged by.
struct Judges {
  const JudgedSurface& hull;
  const JudgedSurface& cut;
  double voxel;
  float mattness;
};

// The samples of one view. Its depths become those of the cut.
void JudgeView(const PreparedView& view,
               const Judges& judges,
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
      const auto before = judges.hull.FirstHit(projection.center, ray);
      const auto behind = judges.cut.FirstHit(projection.center, ray);
      const double unit = double(ray.norm()) / judges.voxel;
      if (!before || !behind ||
          (behind->distance - before->distance) * unit < kInside) {
        continue;
      }
      const size_t k = size_t(y) * map->width + x;
      const auto of_hull = judges.hull.AgreementAt(*before);
      if (!of_hull ||
          (*of_hull < kAgreed &&
           (double(depths[k]) - behind->distance) * unit > kBehind)) {
        continue;
      }
      map->depths[k] = float(behind->distance);
      const float of_cut = judges.cut.AgreementAt(*behind).value_or(0);
      (*confidence)[k] = std::max(map->detail[k], judges.mattness) *
                         Ramp(of_cut - *of_hull, kLess, kMore);
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
  const Judges judges{outer,
                      inner,
                      1.0 / double(cut.voxels.Resolution()),
                      Mattness(views, maps, outer, context)};
  ReliableDepths judged{maps, std::vector<std::vector<float>>(maps.size())};
  ParallelFor(context, maps.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      JudgeView(views[i], judges, &judged.maps[i], &judged.confidence[i]);
    }
  });
  return judged;
}

}  // namespace octacut
