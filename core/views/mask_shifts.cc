#include "core/views/mask_shifts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/core.hpp>
#include <optional>

#include "core/base/median.h"
#include "core/views/coarse_shift.h"

namespace octacut {
namespace {

// The share of the masks that have to agree with their median, if the others
// are to be moved to it.
constexpr double kMostMasks = 0.75;

// What most masks have in common; 0 where they do not agree.
float CommonShift(const std::vector<std::optional<float>>& shifts) {
  std::vector<float> known;
  for (const std::optional<float>& shift : shifts) {
    if (shift) {
      known.push_back(*shift);
    }
  }
  if (known.empty()) {
    return 0;
  }
  const float median = Median(known);
  const auto num_near =
      std::count_if(known.begin(), known.end(), [median](float shift) {
        return std::abs(shift - median) <= kMinCoarseShift;
      });
  return double(num_near) >= kMostMasks * double(known.size()) ? median : 0;
}

}  // namespace

std::vector<MaskShift> FindMaskShifts(const ViewSet& views,
                                      const Context& context) {
  std::vector<std::optional<float>> shifts;
  for (const EdgePositions& edges : FindEdgesOfViews(views, context)) {
    shifts.push_back(FindCoarseShift(edges).shift);
  }
  const float common = CommonShift(shifts);
  std::vector<MaskShift> off;
  for (size_t i = 0; i < shifts.size(); ++i) {
    if (shifts[i] && std::abs(*shifts[i] - common) > kMinCoarseShift) {
      off.push_back({i, *shifts[i] - common});
    }
  }
  return off;
}

cv::Mat MoveBorderInside(const Silhouette& silhouette,
                         const cv::Size& size,
                         double pixels) {
  cv::Mat mask(size, CV_8UC1);
  mask.forEach<uint8_t>([&](uint8_t& coverage, const int* at) {
    const float inside =
        silhouette.SignedDistance(float(at[1]) + 0.5f, float(at[0]) + 0.5f);
    coverage = cv::saturate_cast<uint8_t>(255 * (inside - pixels + 0.5));
  });
  return mask;
}

}  // namespace octacut
