#include "core/views/border_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <Eigen/Core>
#include <optional>

namespace octacut {
namespace {

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

constexpr int kNumSteps = int(2 * kEdgeRange / kEdgeStep) + 1;
constexpr int kHalfEdge = int(kEdgeWidth / 2 / kEdgeStep);
constexpr int kClippedSteps = int(kClippedReach / kEdgeStep);

struct Profile {
  std::array<Eigen::Vector3f, kLineSamples> linear;
  std::array<Eigen::Vector3f, kLineSamples> grey;
  std::array<float, kLineSamples> coverage;  // of the mask
  std::array<uint8_t, kLineSamples> clipped;
};

// By step: the difference of the light half an edge before and behind it.
using Contrast = std::array<float, kNumSteps>;

class BorderLines {
 public:
  explicit BorderLines(const PreparedView& view)
      : view_(view), image_(view.pyramid.Level(0)) {
    for (int i = 0; i < 256; ++i) {
      linear_[i] = float(255 * std::pow(i / 255.0, 2.2));
    }
  }

  std::vector<BorderLine> Find() const {
    std::vector<BorderLine> lines;
    const std::vector<Eigen::Vector2f> points = Points();
    const size_t stride = points.size() / kMaxPoints + 1;
    for (size_t i = 0; i < points.size(); i += stride) {
      AddLine(points[i], &lines);
    }
    return lines;
  }

 private:
  float Inside(int x, int y) const {
    return view_.silhouette.SignedDistance(float(x) + 0.5f, float(y) + 0.5f);
  }

  // Pixels of the object beside background, clear of the frame.
  std::vector<Eigen::Vector2f> Points() const {
    const int margin =
        int(kEdgeRange + float(kLineMargin) * kEdgeStep + kNormalReach) + 1;
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

  void AddLine(const Eigen::Vector2f& point,
               std::vector<BorderLine>* lines) const {
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
    if (const std::optional<float> border = MaskBorder(profile)) {
      const Contrast contrast = EdgeContrast(profile);
      const BorderLine line{
          profile.linear,
          *border,
          ClearEdge(StrongestEdge(contrast), contrast, profile),
          ClearEdge(NearestEdge(contrast), contrast, profile)};
      if (line.strongest || line.nearest) {
        lines->push_back(line);
      }
    }
  }

  Profile SampleLine(const Eigen::Vector2f& border,
                     const Eigen::Vector2f& inward) const {
    Profile profile;
    for (int i = 0; i < int(profile.linear.size()); ++i) {
      const float t = PixelsFromMiddle(float(i));
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
    constexpr int kMiddle = kLineSamples / 2;
    constexpr int kReach = int(kBorderReach / kEdgeStep);
    std::optional<float> border;
    for (int i = kMiddle - kReach; i < kMiddle + kReach; ++i) {
      const float before = profile.coverage[i];
      const float after = profile.coverage[i + 1];
      if (before < kObjectCoverage && after >= kObjectCoverage) {
        const float at = (float(i - kMiddle) +
                          (kObjectCoverage - before) / (after - before)) *
                         kEdgeStep;
        if (!border || std::abs(at) < std::abs(*border)) {
          border = at;
        }
      }
    }
    return border;
  }

  static Contrast EdgeContrast(const Profile& profile) {
    Contrast contrast;
    for (int i = 0; i < kNumSteps; ++i) {
      contrast[i] = (profile.linear[i + kLineMargin + kHalfEdge] -
                     profile.linear[i + kLineMargin - kHalfEdge])
                        .norm();
    }
    return contrast;
  }

  static bool IsEdge(int i, const Contrast& contrast) {
    return contrast[i] >= contrast[i - 1] && contrast[i] > contrast[i + 1];
  }

  static int StrongestEdge(const Contrast& contrast) {
    return int(std::max_element(contrast.begin(), contrast.end()) -
               contrast.begin());
  }

  // The edge nearest to the middle among those that are comparable to the
  // strongest one.
  static int NearestEdge(const Contrast& contrast) {
    const int strongest = StrongestEdge(contrast);
    int nearest = strongest;
    for (int i = 1; i + 1 < kNumSteps; ++i) {
      if (IsEdge(i, contrast) &&
          contrast[i] >= kComparableContrast * contrast[strongest] &&
          std::abs(i - kNumSteps / 2) < std::abs(nearest - kNumSteps / 2)) {
        nearest = i;
      }
    }
    return nearest;
  }

  // The edge at step `best`; none if it is at an end, too faint, or beside
  // clipped pixels.
  static std::optional<BorderEdge> ClearEdge(int best,
                                             const Contrast& contrast,
                                             const Profile& profile) {
    const int middle = best + kLineMargin;
    if (best == 0 || best + 1 == kNumSteps ||
        (profile.grey[middle + kHalfEdge] - profile.grey[middle - kHalfEdge])
                .norm() < kMinContrast) {
      return std::nullopt;
    }
    if (std::any_of(profile.clipped.begin() + middle - kClippedSteps,
                    profile.clipped.begin() + middle + kClippedSteps + 1,
                    [](uint8_t clipped) { return clipped != 0; })) {
      return std::nullopt;
    }
    const float shift = ParabolaExtremum(
        contrast[best - 1], contrast[best], contrast[best + 1]);
    return BorderEdge{middle,
                      PixelsFromMiddle(float(middle) + shift),
                      StandsAlone(best, contrast)};
  }

  static bool StandsAlone(int best, const Contrast& contrast) {
    const int begin = std::max(best - kOutlineWindow - kHalfEdge, 1);
    const int end = std::min(best + kOutlineWindow + kHalfEdge, kNumSteps - 2);
    for (int i = begin; i <= end; ++i) {
      if (i != best && IsEdge(i, contrast) &&
          contrast[i] >= kComparableContrast * contrast[best]) {
        return false;
      }
    }
    return true;
  }

  const PreparedView& view_;
  const PyramidLevel& image_;
  std::array<float, 256> linear_;
};

}  // namespace

std::vector<BorderLine> FindBorderLines(const PreparedView& view) {
  return BorderLines(view).Find();
}

}  // namespace octacut
