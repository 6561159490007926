#include "core/benchmark/evaluate/silhouette_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/benchmark/evaluate/outline.h"
#include "core/raycast/render_silhouette.h"
#include "core/scene/scene.h"

namespace octacut {
namespace {

void AppendDistances(const Outline& from,
                     const Outline& to,
                     double largest,
                     OutlineDistances* distances) {
  for (const OutlineSegment& segment : from.Segments()) {
    const double distance = to.Distance((segment.begin + segment.end) / 2);
    distances->emplace_back(std::min(distance, largest),
                            (segment.end - segment.begin).norm());
  }
}

// Weighted mean; 0 of nothing.
double Mean(const OutlineDistances& distances) {
  double sum = 0;
  double length = 0;
  for (const auto& [distance, weight] : distances) {
    sum += distance * weight;
    length += weight;
  }
  return length > 0 ? sum / length : 0;
}

}  // namespace

double OutlinePercentile(OutlineDistances distances, double fraction) {
  std::sort(distances.begin(), distances.end());
  double length = 0;
  for (const auto& [distance, weight] : distances) {
    length += weight;
  }
  double sum = 0;
  for (const auto& [distance, weight] : distances) {
    sum += weight;
    if (sum >= fraction * length) {
      return distance;
    }
  }
  return distances.empty() ? 0 : distances.back().first;
}

ViewSilhouette CompareSilhouettes(const cv::Mat& mask,
                                  const cv::Mat& mesh_coverage,
                                  OutlineDistances* distances) {
  ViewSilhouette view;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const bool object = mask.at<uint8_t>(y, x) >= kObjectThreshold;
      const bool mesh = mesh_coverage.at<uint8_t>(y, x) >= kObjectThreshold;
      view.object_pixels += object;
      view.mesh_pixels += mesh;
      view.common_pixels += object && mesh;
    }
  }
  const Outline of_mask(mask);
  const Outline of_mesh(mesh_coverage);
  const double diagonal = std::hypot(mask.cols, mask.rows);
  OutlineDistances own;
  AppendDistances(of_mask, of_mesh, diagonal, &own);
  AppendDistances(of_mesh, of_mask, diagonal, &own);
  view.outline_mean = Mean(own);
  for (const auto& [distance, weight] : own) {
    view.outline_max = std::max(view.outline_max, distance);
  }
  distances->insert(distances->end(), own.begin(), own.end());
  return view;
}

SilhouetteAgreement MeasureSilhouettes(const RayScene& rays,
                                       const std::vector<View>& views,
                                       const std::vector<cv::Mat>& depths,
                                       const Context& context) {
  SilhouetteAgreement agreement;
  agreement.views.resize(views.size());
  std::vector<OutlineDistances> distances(views.size());
  Phase phase(context, "comparison of mesh and masks", views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    const Context alone(1);  // views are measured side by side
    for (size_t i = begin; i < end; ++i) {
      agreement.views[i] = CompareSilhouettes(
          views[i].mask,
          RenderSilhouette(
              rays, views[i].camera, views[i].cam_from_world, depths[i], alone),
          &distances[i]);
      phase.Advance();
    }
  });
  ViewSilhouette total;
  OutlineDistances all;
  for (size_t i = 0; i < views.size(); ++i) {
    total.object_pixels += agreement.views[i].object_pixels;
    total.mesh_pixels += agreement.views[i].mesh_pixels;
    total.common_pixels += agreement.views[i].common_pixels;
    all.insert(all.end(), distances[i].begin(), distances[i].end());
  }
  if (total.object_pixels == 0) {
    throw InputError("silhouettes: no view has a mask with an object");
  }
  const auto object = double(total.object_pixels);
  const double excess = double(total.mesh_pixels - total.common_pixels);
  agreement.intersection_over_union =
      double(total.common_pixels) / (object + excess);
  agreement.missed = (object - double(total.common_pixels)) / object;
  agreement.excess = excess / object;
  agreement.outline_mean = Mean(all);
  agreement.outline_percentile_95 = OutlinePercentile(std::move(all), 0.95);
  return agreement;
}

}  // namespace octacut
