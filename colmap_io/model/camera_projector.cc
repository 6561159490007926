#include "colmap_io/model/camera_projector.h"

#include <algorithm>
#include <cmath>

#include "colmap_io/model/lens_models.h"
#include "core/base/error.h"

namespace octacut {
namespace {

// Calls function.template operator()<Model>() for the model's number.
template <typename Function>
decltype(auto) WithModel(int model_id, const Function& function) {
  using namespace lens;
  namespace id = camera_model;
  switch (model_id) {
    case id::kSimplePinhole:
    case id::kPinhole:
      return function.template operator()<PerspectiveModel<NoDistortion>>();
    case id::kSimpleRadial:
      return function
          .template operator()<PerspectiveModel<RadialPolynomial<1>>>();
    case id::kRadial:
      return function
          .template operator()<PerspectiveModel<RadialPolynomial<2>>>();
    case id::kOpenCV:
      return function.template operator()<PerspectiveModel<OpenCVDistortion>>();
    case id::kFullOpenCV:
      return function
          .template operator()<PerspectiveModel<FullOpenCVDistortion>>();
    case id::kFOV:
      return function.template operator()<FOVModel>();
    case id::kSimpleFisheye:
    case id::kFisheye:
      return function.template operator()<FisheyeModel<NoDistortion>>();
    case id::kSimpleRadialFisheye:
      return function.template operator()<FisheyeModel<RadialPolynomial<1>>>();
    case id::kRadialFisheye:
      return function.template operator()<FisheyeModel<RadialPolynomial<2>>>();
    case id::kOpenCVFisheye:
      return function.template operator()<FisheyeModel<RadialPolynomial<4>>>();
    case id::kThinPrismFisheye:
      return function.template operator()<FisheyeModel<ThinPrismDistortion>>();
    case id::kRadTanThinPrismFisheye:
      return function
          .template operator()<FisheyeModel<RadTanThinPrismDistortion>>();
    case id::kSimpleDivision:
    case id::kDivision:
      return function.template operator()<DivisionModel>();
    case id::kEUCM:
      return function.template operator()<EUCMModel>();
    default:
      throw InvariantError("camera model without a projection");
  }
}

template <typename Model>
void ProjectRow(const CameraIntrinsics& intrinsics,
                const Eigen::Vector3d& first,
                const Eigen::Vector3d& step,
                size_t count,
                float* x,
                float* y) {
  constexpr double kFarthest = -CameraProjector::kNoPixel;
  // int, as the conversion of wider ones to double cannot be vectorized.
  for (int i = 0; i < int(count); ++i) {
    const double t = i;
    double px, py;
    const bool projects = Model::Project(intrinsics,
                                         first.x() + t * step.x(),
                                         first.y() + t * step.y(),
                                         first.z() + t * step.z(),
                                         &px,
                                         &py);
    // Written so that a NaN counts as outside, too.
    const bool inside =
        projects & (std::abs(px) < kFarthest) & (std::abs(py) < kFarthest);
    x[i] = inside ? float(px) : CameraProjector::kNoPixel;
    y[i] = inside ? float(py) : CameraProjector::kNoPixel;
  }
}

// Points first + i * step.
struct PointRow {
  const Eigen::Vector3d& first;
  const Eigen::Vector3d& step;
  size_t count;
};

// flatten: everything below is compiled for the instruction set at hand.
// Without fused operations, wider vectors give the same bits.
__attribute__((flatten)) void ProjectRowOfModel(int model_id,
                                                const CameraIntrinsics& in,
                                                const PointRow& row,
                                                float* x,
                                                float* y) {
  WithModel(model_id, [&]<typename Model>() {
    ProjectRow<Model>(in, row.first, row.step, row.count, x, y);
  });
}

#if defined(__x86_64__)
__attribute__((target("avx2"), flatten)) void ProjectRowOfModelAvx2(
    int model_id,
    const CameraIntrinsics& in,
    const PointRow& row,
    float* x,
    float* y) {
  WithModel(model_id, [&]<typename Model>() {
    ProjectRow<Model>(in, row.first, row.step, row.count, x, y);
  });
}
#endif

}  // namespace

CameraProjector::CameraProjector(const SparseCamera& camera)
    : model_id_(camera.model_id) {
  CheckCamera(camera, "camera model");
  const CameraModelInfo& info = *FindCameraModel(camera.model_id);
  const double* param = camera.params.data();
  intrinsics_.fx = *param;
  if (info.num_focal_lengths == 2) ++param;
  intrinsics_.fy = *param++;
  intrinsics_.cx = *param++;
  intrinsics_.cy = *param++;
  std::copy(param,
            camera.params.data() + camera.params.size(),
            intrinsics_.extra.begin());
  WithModel(model_id_, [&]<typename Model>() { Model::Prepare(&intrinsics_); });
}

std::optional<Eigen::Vector2d> CameraProjector::ImgFromCam(
    const Eigen::Vector3d& ray) const {
  Eigen::Vector2d pixel;
  const bool projects = WithModel(model_id_, [&]<typename Model>() {
    return Model::Project(
        intrinsics_, ray.x(), ray.y(), ray.z(), &pixel.x(), &pixel.y());
  });
  if (!projects || !pixel.allFinite()) return std::nullopt;
  return pixel;
}

std::optional<Eigen::Vector3d> CameraProjector::CamFromImg(
    const Eigen::Vector2d& pixel) const {
  Eigen::Vector3d ray;
  const bool has_ray = WithModel(model_id_, [&]<typename Model>() {
    return Model::Unproject(intrinsics_, pixel.x(), pixel.y(), &ray);
  });
  if (!has_ray || !ray.allFinite()) return std::nullopt;
  return ray.normalized();
}

void CameraProjector::ImgFromCamRow(const Eigen::Vector3d& first,
                                    const Eigen::Vector3d& step,
                                    size_t count,
                                    float* x,
                                    float* y) const {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    ProjectRowOfModelAvx2(model_id_, intrinsics_, {first, step, count}, x, y);
    return;
  }
#endif
  ProjectRowOfModel(model_id_, intrinsics_, {first, step, count}, x, y);
}

}  // namespace octacut
