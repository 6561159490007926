#include "core/verdict/silhouette_check.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <utility>

#include "core/base/parallel.h"
#include "core/verdict/denied_pixels.h"
#include "core/verdict/mesh_silhouette.h"

namespace octacut {
namespace {

// Errors by the sampling of the mask and of the rays, half a pixel each.
constexpr double kSampling = 1;

// A view of `check` and what its missed pixels say of the other masks.
struct CheckedView {
  PixelCounts counts;
  std::vector<size_t> denied_by;
};

MaskCheck Gather(const std::vector<CheckedView>& checked) {
  MaskCheck check;
  check.denied_of_others.resize(checked.size());
  for (const CheckedView& view : checked) {
    check.views.push_back(view.counts);
    check.total += view.counts;
    for (size_t i = 0; i < view.denied_by.size(); ++i) {
      check.denied_of_others[i] += view.denied_by[i];
    }
  }
  return check;
}

}  // namespace

BorderUncertainty UncertaintyOfBorders(double border_shift,
                                       double mask_tolerance) {
  return {kSampling + std::max(0.0, border_shift),
          kSampling + std::max(mask_tolerance, -border_shift)};
}

PixelCounts& PixelCounts::operator+=(const PixelCounts& other) {
  object += other.object;
  border += other.border;
  covered += other.covered;
  unsure += other.unsure;
  missed += other.missed;
  contradicted += other.contradicted;
  exceeded += other.exceeded;
  surely_exceeded += other.surely_exceeded;
  return *this;
}

PixelCounts CountPixels(const Silhouette& silhouette,
                        const cv::Mat& mesh,
                        const BorderUncertainty& uncertainty,
                        cv::Mat* missed) {
  PixelCounts counts;
  *missed = cv::Mat::zeros(mesh.size(), CV_8UC1);
  for (int y = 0; y < mesh.rows; ++y) {
    for (int x = 0; x < mesh.cols; ++x) {
      const float u = float(x) + 0.5f;
      const float v = float(y) + 0.5f;
      if (!silhouette.IsKnown(u, v)) {
        continue;
      }
      const float depth = silhouette.SignedDistance(u, v);
      const bool is_covered = mesh.at<uint8_t>(y, x) != 0;
      if (depth <= 0) {
        counts.exceeded += is_covered;
        counts.surely_exceeded += is_covered && depth < -uncertainty.outward;
        continue;
      }
      const bool is_border = depth <= uncertainty.inward;
      counts.object += 1;
      counts.border += is_border;
      counts.covered += is_covered;
      counts.unsure += is_border && !is_covered;
      missed->at<uint8_t>(y, x) = is_border || is_covered ? 0 : 255;
    }
  }
  counts.missed = size_t(cv::countNonZero(*missed));
  return counts;
}

SilhouetteCheck CheckSilhouettes(
    const RayScene& rays,
    const std::vector<View>& given,
    const std::vector<View>& repaired,
    const ViewSet& views,
    const std::vector<MaskUncertainty>& uncertainties,
    const Context& context) {
  Phase phase(context, "comparison of mesh and masks", views.size());
  std::vector<CheckedView> of_given(views.size());
  std::vector<CheckedView> of_repaired(views.size());
  SilhouetteCheck check;
  check.missed.resize(views.size());
  std::vector<double> margins;
  margins.reserve(views.size());
  for (const MaskUncertainty& uncertainty : uncertainties) {
    margins.push_back(uncertainty.repaired.outward);
  }
  ParallelEach(context, views.size(), 1, [&](size_t i) {
    const cv::Mat mesh = RenderHits(rays, views[i]);
    const auto checked = [&](const Silhouette& silhouette,
                             const BorderUncertainty& uncertainty,
                             cv::Mat* missed) {
      CheckedView view;
      view.counts = CountPixels(silhouette, mesh, uncertainty, missed);
      DeniedPixels denied = FindDeniedPixels(views, margins, i, *missed);
      view.counts.contradicted = denied.count;
      view.denied_by = std::move(denied.by_view);
      return view;
    };
    of_repaired[i] = checked(
        views[i].silhouette, uncertainties[i].repaired, &check.missed[i]);
    cv::Mat missed;
    of_given[i] = given[i].mask.data == repaired[i].mask.data
                      ? of_repaired[i]
                      : checked(Silhouette(given[i].mask, given[i].unknown),
                                uncertainties[i].given,
                                &missed);
    phase.Advance();
  });
  check.given = Gather(of_given);
  check.repaired = Gather(of_repaired);
  return check;
}

}  // namespace octacut
