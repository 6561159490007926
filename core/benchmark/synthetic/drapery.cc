#include "core/benchmark/synthetic/drapery.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/check_option.h"

namespace octacut {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kRadius = 0.8;
constexpr double kHalfHeight = 0.85;
constexpr double kRounding = 0.12;
// Grooves are in full depth up to this height and gone at the other.
constexpr double kFullHeight = 0.35;
constexpr double kEndHeight = 0.72;
// The radius at the top in units of that at the hem.
constexpr double kTopScale = 0.72;
// The folds turn about the axis, by so many radians to and fro.
constexpr double kSway = 0.16;
constexpr double kSwayFrequency = 3.2;
// By how many of its widths a groove opens from bottom to ridge, on each side;
// and how far the ridge is rounded, likewise.
constexpr double kOpening = 0.24;
constexpr double kRidgeBlend = 0.5;

struct Groove {
  Vector2d outward;  // from the axis, of unit length
  double width;
  double depth;
};

// Angles at the axis that a fold takes: a groove and a ridge, half way down.
double FoldAngle(double width, double ratio) {
  return 2 * width / (kRadius - ratio * width / 2);
}

// Widths of the folds of half the column, widest first, that fill it best.
std::vector<double> FoldWidths(const DraperyOptions& options) {
  std::vector<double> best;
  for (int count = 2;; ++count) {
    std::vector<double> widths;
    double angle = 0;
    for (int i = 0; i < count; ++i) {
      widths.push_back(
          options.max_width *
          std::pow(options.min_width / options.max_width, i / (count - 1.0)));
      angle += FoldAngle(widths.back(), options.depth);
    }
    if (angle > std::numbers::pi) {
      return best;
    }
    best = std::move(widths);
  }
}

std::vector<Groove> LayOutGrooves(const DraperyOptions& options) {
  const std::vector<double> widths = FoldWidths(options);
  CheckOption(!widths.empty(),
              "fold_width",
              options.max_width,
              "must leave room for folds around the column");
  double total = 0;
  for (const double width : widths) {
    total += FoldAngle(width, options.depth);
  }
  // What is left over makes the ridges wider, all in the same ratio.
  const double stretch = std::numbers::pi / total;
  std::vector<Groove> grooves;
  double angle = 0;
  for (const double width : widths) {
    const double half = stretch * FoldAngle(width, options.depth) / 2;
    angle += half;
    for (const double side : {-1.0, 1.0}) {
      grooves.push_back({{std::cos(angle), side * std::sin(angle)},
                         width,
                         options.depth * width});
    }
    angle += half;
  }
  return grooves;
}

// 1 where grooves are in full depth, 0 where they have ended.
double FullnessAt(double z) {
  const double t =
      std::clamp((kEndHeight - z) / (kEndHeight - kFullHeight), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// The distance to a groove's cross-section, which gets wider outward: a round
// bar in two dimensions from the bottom to beyond the column's surface.
double GrooveValue(const Groove& groove, double fullness, const Vector2d& p) {
  const double growth = kOpening * groove.width / groove.depth;
  // So that half way down half the width is on each side.
  const double bottom_radius =
      (groove.width - growth * groove.depth) / 2 / (1 - growth);
  // Raised by more than the depth it is out of the column.
  const double depth = fullness * (groove.depth + groove.width) - groove.width;
  const double bottom = kRadius - depth + bottom_radius;
  const double along = p.dot(groove.outward);
  const double across = groove.outward.x() * p.y() - groove.outward.y() * p.x();
  const double beyond = std::max(along - bottom, 0.0);
  return std::hypot(across, along - bottom - beyond) - bottom_radius -
         growth * std::min(beyond, groove.depth + groove.width);
}

// From the swaying body, narrower above, to an upright column.
Vector3d Straighten(const Vector3d& p) {
  const double height =
      std::clamp((p.z() + kHalfHeight) / (2 * kHalfHeight), 0.0, 1.0);
  const double scale = 1 - (1 - kTopScale) * height;
  const double angle = -kSway * std::sin(kSwayFrequency * p.z());
  const Eigen::Rotation2Dd turn(angle);
  const Vector2d across = turn * p.head<2>() / scale;
  return {across.x(), across.y(), p.z()};
}

}  // namespace

ImplicitShape MakeDrapery(const DraperyOptions& options) {
  CheckOption(options.depth * options.max_width < kRadius / 2,
              "fold_depth",
              options.depth,
              "must not reach further than half way to the column's axis");
  const ImplicitShape column = MakeCylinder(kRadius, kHalfHeight, kRounding);
  const auto value = [column,
                      grooves = LayOutGrooves(options)](const Vector3d& point) {
    const Vector3d p = Straighten(point);
    const double fullness = FullnessAt(p.z());
    const Vector2d across = p.head<2>();
    double result = column(p);
    if (fullness <= 0) {
      return result;
    }
    for (const Groove& groove : grooves) {
      // The groove's line through the axis is no further than its bar.
      const double aside = std::abs(groove.outward.x() * across.y() -
                                    groove.outward.y() * across.x());
      const double blend = kRidgeBlend * groove.width;
      if (aside - 2 * groove.width > blend - result) {
        continue;
      }
      result =
          -BlendedMin(-result, GrooveValue(groove, fullness, across), blend);
    }
    return result;
  };
  // Across the grooves a bar's own slope, along them that of their depth; both
  // made steeper where the body is narrower, and by the sway and the narrowing.
  const double taper = kOpening / options.depth;
  const double rise = 1.5 * (options.depth + 1) * options.max_width /
                      (kEndHeight - kFullHeight);
  const double aside =
      kRadius * (kSway * kSwayFrequency + (1 - kTopScale) / (2 * kHalfHeight));
  const double lipschitz =
      (std::hypot(1 + taper, rise) + (1 + taper) * aside) / kTopScale;
  return {value, column.box, lipschitz};
}

}  // namespace octacut
