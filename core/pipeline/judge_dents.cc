#include "core/pipeline/judge_dents.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/median.h"
#include "core/base/parallel.h"
#include "core/base/ramp.h"
#include "core/pipeline/surface_agreement.h"
#include "core/pipeline/unfounded_pits.h"
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
// lids of hollows. Without detail, it is a highlight like the cut.
constexpr double kBehind = 1;
constexpr float kAgreed = 0.4f;
// Samples of the hull with less detail tell whether the object is matt.
constexpr float kHalfDetail = 0.5f;
// Of those along a row or a column, one in so many is asked.
constexpr int kMattnessStep = 3;

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

  // As FindUnfoundedPits has them; empty if one of the surfaces is.
  std::vector<uint8_t> FindPits(const JudgedSurface& hull,
                                double voxel,
                                const Context& context) const {
    return rays_ && hull.rays_
               ? FindUnfoundedPits(
                     measured_, means_, *hull.rays_, voxel, context)
               : std::vector<uint8_t>();
  }

  uint32_t VertexOf(const RayScene::Hit& hit) const {
    return measured_.mesh.triangles[hit.triangle][0];
  }

  // None where it is not seen.
  std::optional<float> AgreementAt(const RayScene::Hit& hit) const {
    const float mean = means_[PointOf(hit)];
    return mean == SurfaceAgreement::kUnmeasured ? std::nullopt
                                                 : std::optional(mean);
  }

  // None where it is not seen.
  std::optional<float> MattnessAt(const RayScene::Hit& hit) const {
    const SurfaceAgreement& agreement = measured_.agreement;
    const uint32_t point = PointOf(hit);
    return agreement.is_measured[point]
               ? std::optional(agreement.mattness[point])
               : std::nullopt;
  }

 private:
  uint32_t PointOf(const RayScene::Hit& hit) const {
    return measured_.agreement.points.point_of[VertexOf(hit)];
  }

  MeasuredSurface measured_;
  std::vector<float> means_;
  std::optional<RayScene> rays_;
};

// Appends the mattness of points of the hull that a view shows without detail.
void AppendMattness(const PreparedView& view,
                    const SweptDepthMap& map,
                    const JudgedSurface& hull,
                    std::vector<float>* mattness) {
  const ViewProjection& projection = view.projection;
  const Eigen::Matrix3f rays = projection.RaysOfPixels();
  for (int y = 0; y < map.height; y += kMattnessStep) {
    for (int x = 0; x < map.width; x += kMattnessStep) {
      const Eigen::Vector3f pixel = map.Pixel(x, y);
      if (map.detail[size_t(y) * map.width + x] >= kHalfDetail ||
          view.silhouette.SignedDistance(pixel.x(), pixel.y()) <= 0) {
        continue;
      }
      const auto hit = hull.FirstHit(projection.center, rays * pixel);
      const auto value = hit ? hull.MattnessAt(*hit) : std::nullopt;
      if (value) {
        mattness->push_back(*value);
      }
    }
  }
}

// The median over what has no detail, 0 .. 1; 1 where everything has detail.
float MattnessOfHull(const ViewSet& views,
                     const std::vector<SweptDepthMap>& maps,
                     const JudgedSurface& hull,
                     const Context& context) {
  std::vector<std::vector<float>> of_views(maps.size());
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    AppendMattness(views[i], maps[i], hull, &of_views[i]);
  });
  std::vector<float> mattness;
  for (const std::vector<float>& of_view : of_views) {
    mattness.insert(mattness.end(), of_view.begin(), of_view.end());
  }
  return mattness.empty() ? 1 : Median(std::move(mattness));
}

// What the samples of a view are judged by.
struct Judges {
  const JudgedSurface& hull;
  const JudgedSurface& cut;
  std::vector<uint8_t> in_pit;  // vertices of the cut
  double voxel;
  float mattness;
};

// The samples of one view. Its depths become those of the cut.
void JudgeView(const PreparedView& view,
               const Judges& judges,
               SweptDepthMap* map,
               std::vector<float>* confidence,
               std::vector<uint8_t>* in_pit) {
  const ViewProjection& projection = view.projection;
  const Eigen::Matrix3f rays = projection.RaysOfPixels();
  const std::vector<float> depths =
      std::exchange(map->depths, std::vector<float>(map->depths.size(), 0.0f));
  confidence->assign(depths.size(), 1);
  in_pit->assign(depths.size(), 0);
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
      const float trust = std::max(map->detail[k], judges.mattness);
      if (!of_hull ||
          (*of_hull < kAgreed && trust > kHalfDetail &&
           (double(depths[k]) - behind->distance) * unit > kBehind)) {
        continue;
      }
      map->depths[k] = float(behind->distance);
      if (judges.in_pit[judges.cut.VertexOf(*behind)]) {
        (*confidence)[k] = 0;
        (*in_pit)[k] = 1;
        continue;
      }
      const float of_cut = judges.cut.AgreementAt(*behind).value_or(0);
      (*confidence)[k] = trust * Ramp(of_cut - *of_hull, kLess, kMore);
    }
  }
}

}  // namespace

SurfaceVerdict JudgeDents(const ViewSet& views,
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
  const Judges judges{outer,
                      inner,
                      inner.FindPits(outer, voxel, context),
                      voxel,
                      MattnessOfHull(views, maps, outer, context)};
  SurfaceVerdict judged{
      .depths = {maps, std::vector<std::vector<float>>(maps.size())},
      .in_pit = std::vector<std::vector<uint8_t>>(maps.size())};
  ParallelEach(context, maps.size(), 1, [&](size_t i) {
    JudgeView(views[i],
              judges,
              &judged.depths.maps[i],
              &judged.depths.confidence[i],
              &judged.in_pit[i]);
  });
  return judged;
}

}  // namespace octacut
