#include "core/views/border_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Core>
#include <limits>
#include <numeric>
#include <vector>

#include "core/base/median.h"
#include "core/base/parallel.h"

namespace octacut {
namespace {

// Pixels. Masks that are farther off are wrong, not shifted.
constexpr float kRange = 6;
constexpr float kStep = 0.25f;
// Between the two points whose difference is an edge's contrast: the width to
// which lenses and JPEG blur a step.
constexpr float kEdgeWidth = 1.5f;
// From which the direction of a border is taken: beyond the pixels' stairs.
constexpr float kNormalReach = 3;
// Within which the border is found again along that direction.
constexpr float kBorderReach = 1;
// Grey levels, as the file has them: some four times the noise of a photograph.
constexpr float kMinContrast = 8;
// Edges of at least this share of the strongest one's contrast are comparable
// to it (docs/experiments/mask_borders.md).
constexpr float kComparableContrast = 0.5f;
constexpr int kClipped = 250;
// Pixels from an edge within which no pixel may be clipped: what a lens and the
// interpolation spread.
constexpr float kClippedReach = 2;
// Points of a view are enough that its median is known to a hundredth.
constexpr size_t kMaxPoints = 3000;
constexpr size_t kMinPoints = 100;
// Edges at any point at all would lie within a pixel of the peak with a share
// of one sixth.
constexpr double kMinShare = 1.0 / 3;

// The largest shift, in pixels, that edges may cause if the strongest ones and
// the nearest ones do not agree to half a pixel: masks differ by it that cover
// each pixel which the object touches, or only those that it fills. Larger
// shifts are then left to the offsets of refinement.
constexpr float kMaxDoubtfulShift = 1;
// The largest shift at all. At the end of the range, edges of larger shifts are
// cut off, so that the rest of them would be taken for a peak.
constexpr float kMaxShift = kRange - 1;
constexpr double kMaxDisagreement = 0.5;
// The share of edges that agree, from which on the shift is known, and by how
// many pixels it may then be wrong (docs/experiments/mask_borders.md).
constexpr double kMostEdges = 0.5;
constexpr float kEdgeError = 0.1f;

constexpr int kNumSteps = int(2 * kRange / kStep) + 1;
constexpr int kHalfEdge = int(kEdgeWidth / 2 / kStep);
constexpr int kClippedSteps = int(kClippedReach / kStep);

struct Profile {
  std::array<Eigen::Vector3f, kNumSteps + 2 * kHalfEdge> linear;
  std::array<Eigen::Vector3f, kNumSteps + 2 * kHalfEdge> grey;
  std::array<float, kNumSteps + 2 * kHalfEdge> coverage;  // of the mask
  std::array<uint8_t, kNumSteps + 2 * kHalfEdge> clipped;
};

// Pixels by which borders lie outside edges, point by point: outside the
// strongest edge, and outside the nearest one that is comparable to it.
struct EdgeOffsets {
  std::vector<float> strongest;
  std::vector<float> nearest;
};

class BorderLines {
 public:
  explicit BorderLines(const PreparedView& view)
      : view_(view), image_(view.pyramid.Level(0)) {
    for (int i = 0; i < 256; ++i) {
      linear_[i] = float(255 * std::pow(i / 255.0, 2.2));
    }
  }

  // Adds the offsets of the view's points.
  void AddOffsets(EdgeOffsets* offsets) const {
    std::vector<Eigen::Vector2f> points = Points();
    const size_t stride = points.size() / kMaxPoints + 1;
    for (size_t i = 0; i < points.size(); i += stride) {
      AddOffset(points[i], offsets);
    }
  }

 private:
  float Inside(int x, int y) const {
    return view_.silhouette.SignedDistance(float(x) + 0.5f, float(y) + 0.5f);
  }

  // Pixels of the object beside background, clear of the frame.
  std::vector<Eigen::Vector2f> Points() const {
    const int margin = int(kRange + kEdgeWidth + kNormalReach) + 1;
    std::vector<Eigen::Vector2f> points;
    for (int y = margin; y < image_.height - margin; ++y) {
      for (int x = margin; x < image_.width - margin; ++x) {
        if (const float inside = Inside(x, y); inside > 0 && inside < 1) {
          points.emplace_back(float(x) + 0.5f, float(y) + 0.5f);
        }
      }
    }
    return points;
  }

  void AddOffset(const Eigen::Vector2f& point, EdgeOffsets* offsets) const {
    const Silhouette& silhouette = view_.silhouette;
    const auto at = [&](float du, float dv) {
      return silhouette.SignedDistance(point.x() + du, point.y() + dv);
    };
    const Eigen::Vector2f slope(at(kNormalReach, 0) - at(-kNormalReach, 0),
                                at(0, kNormalReach) - at(0, -kNormalReach));
    if (!(slope.norm() > kNormalReach)) {
      return;  // a thin structure, or a corner
    }
    const Eigen::Vector2f inward = slope.normalized();
    const Profile profile = SampleLine(point - at(0, 0) * inward, inward);
    const std::optional<float> border = MaskBorder(profile);
    if (!border) {
      return;
    }
    const auto contrast = EdgeContrast(profile);
    if (const auto edge = EdgeAt(StrongestEdge(contrast), contrast, profile)) {
      offsets->strongest.push_back(*edge - *border);
    }
    if (const auto edge = EdgeAt(NearestEdge(contrast), contrast, profile)) {
      offsets->nearest.push_back(*edge - *border);
    }
  }

  Profile SampleLine(const Eigen::Vector2f& border,
                     const Eigen::Vector2f& inward) const {
    Profile profile;
    for (int i = 0; i < int(profile.linear.size()); ++i) {
      const float t = float(i - kHalfEdge) * kStep - kRange;
      const Eigen::Vector2f p =
          border + t * inward - Eigen::Vector2f::Constant(0.5f);
      Sample(p,
             &profile.linear[i],
             &profile.grey[i],
             &profile.coverage[i],
             &profile.clipped[i]);
    }
    return profile;
  }

  // Bilinear, at coordinates with the first pixel's centre at 0.
  void Sample(const Eigen::Vector2f& p,
              Eigen::Vector3f* linear,
              Eigen::Vector3f* grey,
              float* coverage,
              uint8_t* clipped) const {
    const int x = int(p.x());
    const int y = int(p.y());
    const float fx = p.x() - float(x);
    const float fy = p.y() - float(y);
    linear->setZero();
    grey->setZero();
    *coverage = 0;
    *clipped = 0;
    for (int k = 0; k < 4; ++k) {
      const float weight = ((k & 1) ? fx : 1 - fx) * ((k & 2) ? fy : 1 - fy);
      const uint32_t texel =
          image_.texels[size_t(y + (k >> 1)) * image_.width + x + (k & 1)];
      *coverage += weight * float(texel >> 24);
      for (int c = 0; c < 3; ++c) {
        const int value = int((texel >> (8 * c)) & 255);
        (*linear)[c] += weight * linear_[value];
        (*grey)[c] += weight * float(value);
        *clipped |= value >= kClipped ? 1 : 0;
      }
    }
  }

  // Where the coverage rises through one half nearest to the middle, as
  // refinement has it: distances to pixels' centres are off by a seventh of a
  // pixel where borders are oblique.
  static std::optional<float> MaskBorder(const Profile& profile) {
    constexpr int kMiddle = kNumSteps / 2 + kHalfEdge;
    constexpr int kReach = int(kBorderReach / kStep);
    std::optional<float> border;
    for (int i = kMiddle - kReach; i < kMiddle + kReach; ++i) {
      const float before = profile.coverage[i];
      const float after = profile.coverage[i + 1];
      if (before < kObjectCoverage && after >= kObjectCoverage) {
        const float at = (float(i - kMiddle) +
                          (kObjectCoverage - before) / (after - before)) *
                         kStep;
        if (!border || std::abs(at) < std::abs(*border)) {
          border = at;
        }
      }
    }
    return border;
  }

  using Contrast = std::array<float, kNumSteps>;

  static Contrast EdgeContrast(const Profile& profile) {
    Contrast contrast;
    for (int i = 0; i < kNumSteps; ++i) {
      contrast[i] =
          (profile.linear[i + 2 * kHalfEdge] - profile.linear[i]).norm();
    }
    return contrast;
  }

  static int StrongestEdge(const Contrast& contrast) {
    return int(std::max_element(contrast.begin(), contrast.end()) -
               contrast.begin());
  }

  // Of the edges that are comparable to the strongest, the one nearest to the
  // middle.
  static int NearestEdge(const Contrast& contrast) {
    const int strongest = StrongestEdge(contrast);
    int nearest = strongest;
    for (int i = 1; i + 1 < kNumSteps; ++i) {
      const bool is_edge =
          contrast[i] >= contrast[i - 1] && contrast[i] > contrast[i + 1] &&
          contrast[i] >= kComparableContrast * contrast[strongest];
      if (is_edge &&
          std::abs(i - kNumSteps / 2) < std::abs(nearest - kNumSteps / 2)) {
        nearest = i;
      }
    }
    return nearest;
  }

  // The distance of the edge at step `best` from the middle, pixels, unless it
  // is too faint or beside clipped pixels.
  static std::optional<float> EdgeAt(int best,
                                     const Contrast& contrast,
                                     const Profile& profile) {
    if (best == 0 || best + 1 == kNumSteps ||
        (profile.grey[best + 2 * kHalfEdge] - profile.grey[best]).norm() <
            kMinContrast) {
      return std::nullopt;
    }
    const int middle = best + kHalfEdge;
    for (int i = std::max(middle - kClippedSteps, 0);
         i <=
         std::min<int>(middle + kClippedSteps, int(profile.clipped.size()) - 1);
         ++i) {
      if (profile.clipped[i]) {
        return std::nullopt;
      }
    }
    const float curvature =
        contrast[best - 1] - 2 * contrast[best] + contrast[best + 1];
    const float shift =
        curvature < 0
            ? 0.5f * (contrast[best - 1] - contrast[best + 1]) / curvature
            : 0;
    return (float(best) + shift) * kStep - kRange;
  }

  const PreparedView& view_;
  const PyramidLevel& image_;
  std::array<float, 256> linear_;
};

std::vector<float> WithinAPixel(const std::vector<float>& offsets,
                                float center) {
  std::vector<float> near;
  for (const float offset : offsets) {
    if (std::abs(offset - center) < 1) {
      near.push_back(offset);
    }
  }
  return near;
}

// Pixels on both sides of a peak where offsets have to be less frequent.
constexpr int kBesideBegin = int(1.25f / kStep);
constexpr int kBesideEnd = int(2 / kStep);
// Of the greatest height above what is beside: there may be two outlines.
constexpr float kClearHeight = 0.75f;

using Histogram = std::array<int, kNumSteps>;

float MeanOf(const Histogram& counts, int begin, int end) {
  begin = std::max(begin, 0);
  end = std::min(end, kNumSteps);
  return begin < end ? float(std::accumulate(
                           counts.begin() + begin, counts.begin() + end, 0)) /
                           float(end - begin)
                     : 0;
}

// The highest peak of the histogram of the offsets, to a step. Only values
// that are clearly more frequent than those on both sides count as a peak:
// where edges lie at random, the nearest ones are frequent near the border of
// the mask, but values beside are hardly less so.
float Peak(const std::vector<float>& offsets) {
  Histogram counts{};
  for (const float offset : offsets) {
    ++counts[std::clamp(
        int(std::lround((offset + kRange) / kStep)), 0, kNumSteps - 1)];
  }
  std::array<float, kNumSteps> means{};
  std::array<float, kNumSteps> heights{};
  for (int i = 2; i + 2 < kNumSteps; ++i) {
    means[i] = float(counts[i - 2] + 2 * counts[i - 1] + 3 * counts[i] +
                     2 * counts[i + 1] + counts[i + 2]) /
               9;
    heights[i] = means[i] -
                 std::max(MeanOf(counts, i - kBesideEnd, i - kBesideBegin + 1),
                          MeanOf(counts, i + kBesideBegin, i + kBesideEnd + 1));
  }
  const float clear =
      kClearHeight * *std::max_element(heights.begin(), heights.end());
  int best = 0;
  for (int i = 0; i < kNumSteps; ++i) {
    if (heights[i] >= clear && means[i] > means[best]) {
      best = i;
    }
  }
  return float(best) * kStep - kRange;
}

// The mean of the peak, or none if fewer than `min_share` of the offsets lie
// within a pixel of it.
std::optional<BorderEdges> FindPeak(const std::vector<float>& offsets,
                                    double min_share) {
  if (offsets.size() < kMinPoints) {
    return std::nullopt;
  }
  float center = Peak(offsets);
  std::vector<float> near;
  for (int i = 0; i < 3; ++i) {
    near = WithinAPixel(offsets, center);
    if (near.size() < kMinPoints ||
        double(near.size()) < min_share * double(offsets.size())) {
      return std::nullopt;
    }
    center = Median(near);
  }
  BorderEdges edges{.shift = center,
                    .share = double(near.size()) / double(offsets.size())};
  for (float& offset : near) {
    offset = std::abs(offset - center);
  }
  edges.deviation = Median(std::move(near));
  return edges;
}

}  // namespace

std::optional<BorderEdges> MeasureBorderEdges(const ViewSet& views,
                                              const Context& context) {
  std::vector<EdgeOffsets> of_views(views.size());
  ParallelFor(context, views.size(), 1, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (views[i].pyramid.NumLevels() > 0) {
        BorderLines(views[i]).AddOffsets(&of_views[i]);
      }
    }
  });
  EdgeOffsets offsets;
  const auto append = [](const std::vector<float>& from,
                         std::vector<float>* to) {
    to->insert(to->end(), from.begin(), from.end());
  };
  for (const EdgeOffsets& of_view : of_views) {
    append(of_view.strongest, &offsets.strongest);
    append(of_view.nearest, &offsets.nearest);
  }
  // The nearest of many random edges is near, so the strongest ones say whether
  // there is a peak.
  const std::optional<BorderEdges> strongest =
      FindPeak(offsets.strongest, kMinShare);
  std::optional<BorderEdges> edges =
      strongest ? FindPeak(offsets.nearest, 0) : std::nullopt;
  if (edges) {
    edges->share = strongest->share;
    edges->strongest_shift = strongest->shift;
  }
  return edges;
}

std::optional<BorderEdges> ShiftBordersToEdges(const Context& context,
                                               ViewSet* views) {
  const std::optional<BorderEdges> edges = MeasureBorderEdges(*views, context);
  const double disagreement =
      edges ? std::abs(edges->shift - edges->strongest_shift) : 0;
  const double limit =
      disagreement < kMaxDisagreement ? kMaxShift : kMaxDoubtfulShift;
  // The share is that of the strongest edges: it says nothing where those lie
  // elsewhere.
  const bool is_known = edges && edges->share >= kMostEdges &&
                        disagreement < 1 && std::abs(edges->shift) < limit;
  for (PreparedView& view : *views) {
    view.border_shift =
        edges ? float(std::clamp(edges->shift, -limit, limit)) : 0;
    view.border_shift_error =
        is_known ? kEdgeError : std::numeric_limits<float>::infinity();
  }
  return edges;
}

void KeepBorders(ViewSet* views) {
  for (PreparedView& view : *views) {
    view.border_shift = 0;
    view.border_shift_error = 0;
  }
}

}  // namespace octacut
