#include "core/refine/align_views.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "core/base/parallel.h"

namespace octacut {
namespace {

constexpr size_t kResidualGrain = 256;
// With so many points, a pose is known well enough.
constexpr size_t kMaxPoints = 8000;
constexpr size_t kMinPatches = 50;
constexpr int kMinViews = 3;
constexpr float kMinAgreement = 0.5f;
// The residual of a patch that agrees perfectly.
constexpr float kResidualSlack = 0.05f;
// Share of the mean information on shifts by which motion is held back.
constexpr double kDamping = 0.02;
// The largest motion in one step, pixels.
constexpr double kMaxMotion = 2;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
// Turn about the middle of the root cube, shift and growth of all there is.
using Vector7d = Eigen::Matrix<double, 7, 1>;
using Matrix7d = Eigen::Matrix<double, 7, 7>;

// Normal equations of a view's motion.
struct PoseEquations {
  Matrix6d products = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  Matrix6d motions = Matrix6d::Zero();  // of squared pixels
  Matrix7d common = Matrix7d::Zero();   // the same of a common motion
  Eigen::Matrix<double, 7, 6> common_by_own =
      Eigen::Matrix<double, 7, 6>::Zero();
  double information = 0;
  size_t count = 0;

  void Add(const PoseEquations& other) {
    products += other.products;
    right += other.right;
    motions += other.motions;
    common += other.common;
    common_by_own += other.common_by_own;
    information += other.information;
    count += other.count;
  }
};

// The middle of the root cube.
const Eigen::Vector3f kMiddle = Eigen::Vector3f::Constant(0.5f);

// Pixels by which the image of a point moves when the point turns about a
// centre, is shifted (both in unit coordinates) or, last, grows away from it.
Eigen::Matrix<double, 2, 7> MotionOfPixel(const ViewProjection& projection,
                                          const Eigen::Vector3f& point,
                                          const Eigen::Vector3f& center) {
  const Eigen::Vector3f h = projection.Homogeneous(point);
  const Eigen::Vector2f pixel = h.head<2>() / h.z();
  const Eigen::Matrix<float, 2, 3> of_point =
      (projection.linear.topRows<2>() - pixel * projection.linear.row(2)) /
      h.z();
  Eigen::Matrix<float, 2, 7> motion;
  const Eigen::Vector3f arm = point - center;
  for (int i = 0; i < 3; ++i) {
    motion.col(i) = of_point * Eigen::Vector3f::Unit(i).cross(arm);
  }
  motion.middleCols<3>(3) = of_point;
  motion.col(6) = of_point * arm;
  return motion.cast<double>();
}

void AddPoint(const ViewSet& views,
              const LocalSurface& surface,
              SurfacePatch* patch,
              std::vector<PoseEquations>* equations) {
  for (const ImageShift& shift : patch->FindShifts()) {
    if (shift.agreement < kMinAgreement) {
      continue;
    }
    const double weight = 1 / double(shift.residual + kResidualSlack);
    const ViewProjection& projection = views[shift.view].projection;
    const Eigen::Matrix<double, 2, 6> motion =
        MotionOfPixel(projection, surface.center, projection.center)
            .leftCols<6>();
    const Eigen::Matrix<double, 2, 7> common =
        MotionOfPixel(projection, surface.center, kMiddle);
    PoseEquations& of_view = (*equations)[shift.view];
    of_view.products +=
        weight * motion.transpose() * shift.products.cast<double>() * motion;
    of_view.right += weight * motion.transpose() * shift.right.cast<double>();
    of_view.motions += motion.transpose() * motion;
    of_view.common += common.transpose() * common;
    of_view.common_by_own += common.transpose() * motion;
    of_view.information += weight * double(shift.products.trace()) / 2;
    ++of_view.count;
  }
}

Eigen::Matrix3d Rotation(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  return angle > 0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                   : Eigen::Matrix3d::Identity();
}

// The motion of a view's pixels that its equations ask for.
Vector6d SolveMotion(const PoseEquations& equations) {
  if (equations.count < kMinPatches) {
    return Vector6d::Zero();
  }
  const double count = double(equations.count);
  Vector6d step = (equations.products +
                   kDamping * equations.information / count * equations.motions)
                      .ldlt()
                      .solve(equations.right);
  if (!step.allFinite()) {
    return Vector6d::Zero();
  }
  const double motion = std::sqrt(step.dot(equations.motions * step) / count);
  return motion > kMaxMotion ? Vector6d(step * (kMaxMotion / motion)) : step;
}

// What all views do alike, which is no motion of theirs but of the frame: it
// must not carry the surface away.
Vector7d SolveCommonMotion(const std::vector<PoseEquations>& equations,
                           const std::vector<Vector6d>& steps) {
  Matrix7d products = Matrix7d::Zero();
  Vector7d right = Vector7d::Zero();
  for (size_t v = 0; v < steps.size(); ++v) {
    products += equations[v].common;
    right += equations[v].common_by_own * steps[v];
  }
  const Vector7d common = products.ldlt().solve(right);
  return common.allFinite() ? common : Vector7d(Vector7d::Zero());
}

// Moves the image of every point by `step`, and the view along with a frame
// that goes by `common`.
void Move(const Vector6d& step,
          const Vector7d& common,
          ViewProjection* projection) {
  const Eigen::Matrix3d own = Rotation(step.head<3>());
  const Eigen::Matrix3d whole = Rotation(common.head<3>());
  const Eigen::Vector3d middle = kMiddle.cast<double>();
  const Eigen::Matrix3d linear =
      projection->linear.cast<double>() * own * whole.transpose();
  const Eigen::Vector3d moved =
      projection->center.cast<double>() - own.transpose() * step.tail<3>();
  const Eigen::Vector3d center = (1 + common[6]) * whole * (moved - middle) +
                                 middle + common.segment<3>(3);
  projection->linear = linear.cast<float>();
  projection->center = center.cast<float>();
  projection->offset = (-linear * center).cast<float>();
}

}  // namespace

size_t AlignViews(const std::vector<LocalSurface>& surfaces,
                  const std::vector<ChosenViews>& choices,
                  const PatchOptions& patch_options,
                  const Context& context,
                  ViewSet* views) {
  const size_t stride = (surfaces.size() + kMaxPoints - 1) / kMaxPoints;
  const size_t count = surfaces.size() / std::max<size_t>(stride, 1);
  std::vector<std::vector<PoseEquations>> of_chunks(
      NumChunks(count, kResidualGrain));
  ParallelChunks(context,
                 count,
                 kResidualGrain,
                 [&](size_t chunk, size_t begin, size_t end) {
                   std::vector<PoseEquations>& equations = of_chunks[chunk];
                   equations.resize(views->size());
                   SurfacePatch patch(*views, patch_options);
                   for (size_t i = begin; i < end; ++i) {
                     const LocalSurface& surface = surfaces[i * stride];
                     const ChosenViews& chosen = choices[i * stride];
                     if (chosen.count < kMinViews) {
                       continue;
                     }
                     patch.MoveTo(surface, chosen, chosen.pixel);
                     if (patch.NumViews() >= kMinViews) {
                       AddPoint(*views, surface, &patch, &equations);
                     }
                   }
                 });
  std::vector<PoseEquations> equations(views->size());
  for (const std::vector<PoseEquations>& of_chunk : of_chunks) {
    for (size_t v = 0; v < views->size(); ++v) {
      equations[v].Add(of_chunk[v]);
    }
  }
  std::vector<Vector6d> steps;
  steps.reserve(equations.size());
  for (const PoseEquations& of_view : equations) {
    steps.push_back(SolveMotion(of_view));
  }
  const auto num_aligned = static_cast<size_t>(std::count_if(
      equations.begin(), equations.end(), [](const PoseEquations& of_view) {
        return of_view.count >= kMinPatches;
      }));
  if (num_aligned > 0) {
    const Vector7d common = SolveCommonMotion(equations, steps);
    for (size_t v = 0; v < views->size(); ++v) {
      Move(steps[v], common, &(*views)[v].projection);
    }
  }
  return num_aligned;
}

ViewMotion MeasureViewMotion(const std::vector<ViewProjection>& before,
                             const ViewSet& views,
                             const std::vector<Eigen::Vector3d>& points) {
  ViewMotion motion;
  for (size_t v = 0; v < views.size(); ++v) {
    double sum = 0;
    size_t count = 0;
    for (const Eigen::Vector3d& point : points) {
      const auto from = before[v].Project(point.cast<float>());
      const auto to = views[v].projection.Project(point.cast<float>());
      if (from && to) {
        sum += std::hypot(double(to->u - from->u), double(to->v - from->v));
        ++count;
      }
    }
    const double of_view = sum / double(std::max<size_t>(count, 1));
    motion.mean += of_view / double(views.size());
    motion.max = std::max(motion.max, of_view);
  }
  return motion;
}

}  // namespace octacut
