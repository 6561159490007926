#include "core/refine/view_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check_option.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kChoiceGrain = 1024;
constexpr int kRingPoints = 8;

// Views that a point should have, even if its patch bends away from them.
constexpr int kEnoughViews = 4;

float CosineOfDegrees(double degrees) {
  return float(std::cos(degrees * std::numbers::pi / 180));
}

// The cosine of the angle at which views see all of a patch.
float CosineOfPatch(const LocalSurface& surface,
                    double radius,
                    double max_angle) {
  const double turn =
      surface.ConvexCurvature() * radius * 180 / std::numbers::pi;
  return CosineOfDegrees(std::max(max_angle - turn, 0.0));
}

struct Candidate {
  uint16_t view;
  float cosine;  // to the normal
  float weight;
  float pixel;
  Eigen::Vector3f direction;  // to the camera
  float distance;
};

// Views that the point faces, and in which it lies in the frame and on the
// object; those of most weight first.
void FindCandidates(const ViewSet& views,
                    const LocalSurface& surface,
                    float min_cosine,
                    float pixel,
                    std::vector<Candidate>* candidates) {
  candidates->clear();
  for (size_t i = 0; i < views.size(); ++i) {
    const ViewProjection& projection = views[i].projection;
    const Eigen::Vector3f to_camera = projection.center - surface.center;
    const Eigen::Vector3f direction = to_camera.normalized();
    const float cosine = direction.dot(surface.normal);
    if (cosine < min_cosine) {
      continue;
    }
    const std::optional<ProjectedPoint> p =
        projection.ProjectIntoFrame(surface.center);
    if (p && views[i].silhouette.Coverage(p->u, p->v) >= kObjectCoverage) {
      const float own_pixel = p->depth / projection.focal_length;
      const float sharpness = std::min(1.0f, pixel / own_pixel);
      candidates->push_back({uint16_t(i),
                             cosine,
                             cosine * sharpness * sharpness,
                             own_pixel,
                             direction,
                             to_camera.norm()});
    }
  }
  std::sort(candidates->begin(),
            candidates->end(),
            [](const Candidate& a, const Candidate& b) {
              return a.weight != b.weight ? a.weight > b.weight
                                          : a.view < b.view;
            });
}

// Surface behind the camera hides nothing.
bool IsHidden(const RayScene& rays,
              const Eigen::Vector3f& point,
              const Candidate& candidate) {
  return rays.IsOccluded(point.cast<double>(),
                         candidate.direction.cast<double>(),
                         0,
                         candidate.distance);
}

// Whether the view sees the point and what faces it of the ring around.
bool SeesPiece(const RayScene& rays,
               const LocalSurface& surface,
               const Candidate& candidate,
               const LinesOfSight& lines) {
  if (IsHidden(rays,
               surface.center + float(lines.clearance) * surface.normal,
               candidate)) {
    return false;
  }
  const float radius = float(lines.ring_radius) * candidate.pixel;
  for (int k = 0; radius > 0 && k < kRingPoints; ++k) {
    const float angle = 2 * std::numbers::pi_v<float> * float(k) / kRingPoints;
    const float x = radius * std::cos(angle);
    const float y = radius * std::sin(angle);
    if (surface.NormalAt(x, y).dot(candidate.direction) <= 0) {
      continue;
    }
    const Eigen::Vector3f point =
        surface.center + x * surface.tangent_u + y * surface.TangentV() +
        (surface.Height(x, y) + float(lines.ring_clearance)) * surface.normal;
    if (IsHidden(rays, point, candidate)) {
      return false;
    }
  }
  return true;
}

ChosenViews Choose(const RayScene& rays,
                   const LocalSurface& surface,
                   const std::vector<Candidate>& candidates,
                   const LinesOfSight& lines,
                   const ViewChoiceOptions& options) {
  const float patch_cosine =
      CosineOfPatch(surface, lines.patch_radius, options.max_angle);
  const float max_similarity = CosineOfDegrees(options.min_separation);
  ChosenViews chosen;
  float sum = 0;
  std::array<Eigen::Vector3f, ChosenViews::kMaxViews> directions;
  for (const Candidate& candidate : candidates) {
    if (candidate.cosine < patch_cosine && chosen.count >= kEnoughViews) {
      continue;
    }
    const bool is_double = std::any_of(
        directions.begin(),
        directions.begin() + chosen.count,
        [&](const Eigen::Vector3f& direction) {
          return direction.dot(candidate.direction) > max_similarity;
        });
    if (is_double || !SeesPiece(rays, surface, candidate, lines)) {
      continue;
    }
    directions[chosen.count] = candidate.direction;
    chosen.weights[chosen.count] = candidate.weight;
    chosen.views[chosen.count++] = candidate.view;
    chosen.pixel += candidate.weight * candidate.pixel;
    sum += candidate.weight;
    if (chosen.count == options.max_views) {
      break;
    }
  }
  if (chosen.count > 0) {
    chosen.pixel /= sum;
  }
  return chosen;
}

}  // namespace

void ViewChoiceOptions::Check() const {
  CheckOption(max_angle > 0 && max_angle < 90,
              "refinement.max_angle",
              max_angle,
              "must lie between 0 and 90 degrees");
  CheckOption(max_views >= 2 && max_views <= ChosenViews::kMaxViews,
              "refinement.max_views",
              max_views,
              "must be in 2 .. 24");
  CheckOption(min_separation >= 0 && min_separation < 45,
              "refinement.min_separation",
              min_separation,
              "must be at least 0 and below 45 degrees");
}

std::vector<ChosenViews> ChooseViews(const ViewSet& views,
                                     const RayScene& rays,
                                     const std::vector<LocalSurface>& surfaces,
                                     const LinesOfSight& lines,
                                     const ViewChoiceOptions& options,
                                     const Context& context) {
  const float min_cosine = CosineOfDegrees(options.max_angle);
  std::vector<ChosenViews> choices(surfaces.size());
  ParallelFor(
      context, surfaces.size(), kChoiceGrain, [&](size_t begin, size_t end) {
        std::vector<Candidate> candidates;
        for (size_t v = begin; v < end; ++v) {
          FindCandidates(
              views, surfaces[v], min_cosine, float(lines.pixel), &candidates);
          choices[v] = Choose(rays, surfaces[v], candidates, lines, options);
        }
      });
  return choices;
}

}  // namespace octacut
