#include "core/views/border_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/parabola.h"

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

constexpr int kHalfEdge = int(kEdgeWidth / 2 / kEdgeStep);
constexpr int kClippedSteps = int(kClippedReach / kEdgeStep);

struct Profile {
  std::vector<Eigen::Vector3f> linear;
  std::vector<Eigen::Vector3f> grey;
  std::vector<uint8_t> clipped;
};

// By step: the difference of the light half an edge before and behind it.
using Contrast = std::vector<float>;

class BorderLines {
 public:
  // Lines of `range` on both sides of the border.
  BorderLines(const PreparedView& view, float range)
      : view_(view),
        image_(view.pyramid.Level(0)),
        range_(range),
        num_steps_(int(2 * range / kEdgeStep) + 1) {
    for (int i = 0; i < 256; ++i) {
      linear_[i] = float(255 * std::pow(i / 255.0, 2.2));
    }
  }

  std::vector<BorderLine> Find() const {
    std::vector<BorderLine> lines;
    ForEachLine([&](const Profile& profile, float border) {
      const Contrast contrast = EdgeContrast(profile);
      BorderLine line{profile.linear,
                      border,
                      ClearEdge(StrongestEdge(contrast), contrast, profile),
                      ClearEdge(NearestEdge(contrast), contrast, profile)};
      if (line.strongest || line.nearest) {
        lines.push_back(std::move(line));
      }
    });
    return lines;
  }

  EdgePositions FindAll() const {
    EdgePositions positions;
    ForEachLine([&](const Profile& profile, float border) {
      ++positions.num_lines;
      const Contrast contrast = EdgeContrast(profile);
      const float strongest = contrast[StrongestEdge(contrast)];
      for (int i = 1; i + 1 < num_steps_; ++i) {
        const auto edge = IsEdge(i, contrast) ? ClearEdge(i, contrast, profile)
                                              : std::nullopt;
        if (!edge) {
          continue;
        }
        positions.all.push_back(edge->steepest - border);
        if (contrast[i] >= kComparableContrast * strongest) {
          positions.comparable.push_back(positions.all.back());
        }
      }
    });
    return positions;
  }

 private:
  float Inside(int x, int y) const {
    return view_.silhouette.SignedDistance(float(x) + 0.5f, float(y) + 0.5f);
  }

  // Pixels of the object beside background, clear of the frame and of unknown
  // pixels.
  std::vector<Eigen::Vector2f> Points() const {
    const int margin =
        int(range_ + float(kLineMargin) * kEdgeStep + kNormalReach) + 1;
    std::vector<Eigen::Vector2f> points;
    for (int y = margin; y < image_.height - margin; ++y) {
      for (int x = margin; x < image_.width - margin; ++x) {
        if (const float inside = Inside(x, y);
            inside > 0 && inside < 1 && IsKnownAround(x, y, margin)) {
          points.emplace_back(float(x) + 0.5f, float(y) + 0.5f);
        }
      }
    }
    return points;
  }

  // In eight directions.
  bool IsKnownAround(int x, int y, int distance) const {
    for (const int dy : {-distance, 0, distance}) {
      for (const int dx : {-distance, 0, distance}) {
        if (!view_.silhouette.IsKnown(float(x + dx), float(y + dy))) {
          return false;
        }
      }
    }
    return true;
  }

  // Of what a line shows and where on it the border is.
  using LineFunction = std::function<void(const Profile&, float border)>;

  void ForEachLine(const LineFunction& function) const {
    const std::vector<Eigen::Vector2f> points = Points();
    const size_t stride = points.size() / kMaxPoints + 1;
    for (size_t i = 0; i < points.size(); i += stride) {
      LookAt(points[i], function);
    }
  }

  void LookAt(const Eigen::Vector2f& point,
              const LineFunction& function) const {
    const auto at = [&](float du, float dv) {
      return view_.silhouette.SignedDistance(point.x() + du, point.y() + dv);
    };
    const Eigen::Vector2f slope(at(kNormalReach, 0) - at(-kNormalReach, 0),
                                at(0, kNormalReach) - at(0, -kNormalReach));
    if (!(slope.norm() > kNormalReach)) {
      return;  // a thin structure, or a corner
    }
    const Eigen::Vector2f inward = slope.normalized();
    const Eigen::Vector2f middle = point - at(0, 0) * inward;
    if (const std::optional<float> border = MaskBorder(middle, inward)) {
      function(SampleLine(middle, inward), *border);
    }
  }

  Profile SampleLine(const Eigen::Vector2f& middle,
                     const Eigen::Vector2f& inward) const {
    Profile profile;
    for (int i = 0; i < num_steps_ + 2 * kLineMargin; ++i) {
      AddSample(middle + PixelsFromMiddle(float(i), range_) * inward, &profile);
    }
    return profile;
  }

  // Calls `add` with the weights and the values of the pixels around `point` in
  // bilinear interpolation.
  template <typename Add>
  void AroundPoint(const Eigen::Vector2f& point, const Add& add) const {
    const Eigen::Vector2f p = point - Eigen::Vector2f::Constant(0.5f);
    const int x = int(p.x());
    const int y = int(p.y());
    const float fx = p.x() - float(x);
    const float fy = p.y() - float(y);
    for (int k = 0; k < 4; ++k) {
      const float weight = ((k & 1) ? fx : 1 - fx) * ((k & 2) ? fy : 1 - fy);
      add(weight,
          image_.texels[size_t(y + (k >> 1)) * image_.width + x + (k & 1)]);
    }
  }

  void AddSample(const Eigen::Vector2f& point, Profile* profile) const {
    Eigen::Vector3f linear = Eigen::Vector3f::Zero();
    Eigen::Vector3f grey = Eigen::Vector3f::Zero();
    uint8_t clipped = 0;
    AroundPoint(point, [&](float weight, uint32_t texel) {
      for (int c = 0; c < 3; ++c) {
        const int value = int((texel >> (8 * c)) & 255);
        linear[c] += weight * linear_[value];
        grey[c] += weight * float(value);
        clipped |= value >= kClipped ? 1 : 0;
      }
    });
    profile->linear.push_back(linear);
    profile->grey.push_back(grey);
    profile->clipped.push_back(clipped);
  }

  float Coverage(const Eigen::Vector2f& point) const {
    float coverage = 0;
    AroundPoint(point, [&](float weight, uint32_t texel) {
      coverage += weight * float(texel >> 24);
    });
    return coverage;
  }

  // Where the coverage rises through one half nearest to `middle`, in pixels
  // from there, as refinement has it: distances to pixels' centres are off by a
  // seventh of a pixel where borders are oblique.
  std::optional<float> MaskBorder(const Eigen::Vector2f& middle,
                                  const Eigen::Vector2f& inward) const {
    constexpr int kReach = int(kBorderReach / kEdgeStep);
    std::optional<float> border;
    float after = Coverage(middle - kBorderReach * inward);
    for (int i = -kReach; i < kReach; ++i) {
      const float before = after;
      after = Coverage(middle + float(i + 1) * kEdgeStep * inward);
      if (before < kObjectCoverage && after >= kObjectCoverage) {
        const float at =
            (float(i) + (kObjectCoverage - before) / (after - before)) *
            kEdgeStep;
        if (!border || std::abs(at) < std::abs(*border)) {
          border = at;
        }
      }
    }
    return border;
  }

  Contrast EdgeContrast(const Profile& profile) const {
    Contrast contrast(num_steps_);
    for (int i = 0; i < num_steps_; ++i) {
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
    const int middle = int(contrast.size()) / 2;
    for (int i = 1; i + 1 < int(contrast.size()); ++i) {
      if (IsEdge(i, contrast) &&
          contrast[i] >= kComparableContrast * contrast[strongest] &&
          std::abs(i - middle) < std::abs(nearest - middle)) {
        nearest = i;
      }
    }
    return nearest;
  }

  // The edge at step `best`; none if it is at an end, too faint, or beside
  // clipped pixels.
  std::optional<BorderEdge> ClearEdge(int best,
                                      const Contrast& contrast,
                                      const Profile& profile) const {
    const int middle = best + kLineMargin;
    if (best == 0 || best + 1 == num_steps_ ||
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
                      PixelsFromMiddle(float(middle) + shift, range_),
                      StandsAlone(best, contrast)};
  }

  bool StandsAlone(int best, const Contrast& contrast) const {
    const int begin = std::max(best - kOutlineWindow - kHalfEdge, 1);
    const int end = std::min(best + kOutlineWindow + kHalfEdge, num_steps_ - 2);
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
  const float range_;
  const int num_steps_;
  std::array<float, 256> linear_;
};

}  // namespace

std::vector<BorderLine> FindBorderLines(const PreparedView& view) {
  return BorderLines(view, kEdgeRange).Find();
}

EdgePositions FindAllEdges(const PreparedView& view) {
  return BorderLines(view, kWideEdgeRange).FindAll();
}

}  // namespace octacut
