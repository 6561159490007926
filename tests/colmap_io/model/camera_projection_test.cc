// Projections against OpenCV, against the models' definitions, and where they
// end.
#include <gtest/gtest.h>

#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "colmap_io/model/camera_projector.h"
#include "tests/colmap_io/model/test_cameras.h"

namespace octacut {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double kTolerance = 1e-8;  // pixels

// Points in front of the camera, up to 45 degrees off the axis.
std::vector<Vector3d> Points() {
  std::vector<Vector3d> points;
  for (double x = -1; x <= 1; x += 0.125) {
    for (double y = -0.8; y <= 0.8; y += 0.1) {
      points.push_back(Vector3d(x, y, 1) * (2 + x * y));
    }
  }
  return points;
}

std::vector<SparseCamera> CamerasOf(std::initializer_list<int> models) {
  std::vector<SparseCamera> cameras;
  for (const SparseCamera& camera : TestCameras()) {
    for (int model : models) {
      if (camera.model_id == model) cameras.push_back(camera);
    }
  }
  return cameras;
}

// Where OpenCV sees normalized coordinates.
Vector2d OpenCVProject(const Vector2d& normalized,
                       const CameraIntrinsics& in,
                       const std::vector<double>& distortion) {
  const cv::Matx33d k(in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1);
  const std::vector<cv::Point3d> object = {{normalized.x(), normalized.y(), 1}};
  std::vector<cv::Point2d> image;
  cv::projectPoints(object, cv::Vec3d(), cv::Vec3d(), k, distortion, image);
  return {image[0].x, image[0].y};
}

// `expected` is told the intrinsics and a point in front of the camera.
void ExpectProjections(
    std::initializer_list<int> models,
    const std::function<Vector2d(const CameraIntrinsics&, const Vector3d&)>&
        expected) {
  for (const SparseCamera& camera : CamerasOf(models)) {
    SCOPED_TRACE(FindCameraModel(camera.model_id)->name);
    const CameraProjector projector(camera);
    int num_projected = 0;
    for (const Vector3d& point : Points()) {
      const auto pixel = projector.ImgFromCam(point);
      if (!pixel) continue;
      ++num_projected;
      const Vector2d want = expected(projector.Intrinsics(), point);
      ASSERT_NEAR((*pixel - want).norm(), 0, kTolerance) << point.transpose();
    }
    EXPECT_GT(num_projected, 200);
  }
}

// Direction times angle off the axis.
Vector2d Equidistant(const Vector3d& p) {
  const double rho = p.head<2>().norm();
  if (rho == 0) return {0, 0};
  return p.head<2>() / rho * std::acos(p.z() / p.norm());
}

TEST(CameraProjection, PolynomialModelsAgreeWithOpenCV) {
  ExpectProjections({0, 1, 2, 3}, [](const auto& in, const Vector3d& p) {
    const auto& k = in.extra;
    return OpenCVProject(p.hnormalized(), in, {k[0], k[1], 0, 0});
  });
  ExpectProjections({4, 6}, [](const auto& in, const Vector3d& p) {
    return OpenCVProject(
        p.hnormalized(), in, {in.extra.begin(), in.extra.begin() + 8});
  });
}

TEST(CameraProjection, FisheyesAgreeWithOpenCV) {
  ExpectProjections({5, 8, 9, 14, 15}, [](const auto& in, const Vector3d& p) {
    const cv::Matx33d k(in.fx, 0, in.cx, 0, in.fy, in.cy, 0, 0, 1);
    const std::vector<cv::Point3d> object = {{p.x(), p.y(), p.z()}};
    const cv::Vec4d d(in.extra[0], in.extra[1], in.extra[2], in.extra[3]);
    std::vector<cv::Point2d> image;
    cv::fisheye::projectPoints(object, image, cv::Vec3d(), cv::Vec3d(), k, d);
    return Vector2d(image[0].x, image[0].y);
  });
}

// OpenCV's thin prism model on equidistant coordinates; it has no term of the
// eighth power, which is added.
TEST(CameraProjection, ThinPrismFisheyeAgreesWithOpenCV) {
  ExpectProjections({10}, [](const auto& in, const Vector3d& p) -> Vector2d {
    const auto& k = in.extra;
    const Vector2d q = Equidistant(p);
    const Vector2d base = OpenCVProject(
        q, in, {k[0], k[1], k[2], k[3], k[4], 0, 0, 0, k[6], 0, k[7], 0});
    const double r8 = std::pow(q.norm(), 8);
    return base + Vector2d(in.fx * q.x(), in.fy * q.y()) * k[5] * r8;
  });
}

TEST(CameraProjection, RadTanThinPrismFisheyeAgreesWithOpenCV) {
  ExpectProjections({11}, [](const auto& in, const Vector3d& p) {
    const auto& k = in.extra;
    const Vector2d q = Equidistant(p);
    double radial = 1;
    for (int i = 0; i < 6; ++i) {
      radial += k[i] * std::pow(q.squaredNorm(), i + 1);
    }
    // OpenCV's p1 and p2 are this model's p1 and p0.
    return OpenCVProject(
        radial * q,
        in,
        {0, 0, k[7], k[6], 0, 0, 0, 0, k[8], k[9], k[10], k[11]});
  });
}

TEST(CameraProjection, FOVMeetsItsDefinition) {
  ExpectProjections({7}, [](const auto& in, const Vector3d& p) -> Vector2d {
    const double omega = in.extra[0];
    const double r = p.head<2>().norm() / p.z();
    double rd = std::atan(2 * r * std::tan(omega / 2)) / omega;
    // COLMAP's expansion for small omega.
    if (omega < 0.01) rd = r * (1 - omega * omega * (1. / 12 - r * r / 3));
    const Vector2d q =
        r > 0 ? Vector2d(p.head<2>().normalized() * rd) : Vector2d::Zero();
    return Vector2d(in.fx * q.x() + in.cx, in.fy * q.y() + in.cy);
  });
}

// The definitions run from the pixel to the ray.
TEST(CameraProjection, DivisionMeetsItsDefinition) {
  for (const SparseCamera& camera : CamerasOf({12, 13})) {
    const CameraProjector projector(camera);
    const CameraIntrinsics& in = projector.Intrinsics();
    for (double x = 0; x <= 640; x += 40) {
      for (double y = 0; y <= 480; y += 40) {
        const Vector2d q((x - in.cx) / in.fx, (y - in.cy) / in.fy);
        const Vector3d ray(q.x(), q.y(), 1 + in.extra[0] * q.squaredNorm());
        const auto pixel = projector.ImgFromCam(2.5 * ray);
        ASSERT_TRUE(pixel);
        ASSERT_NEAR((*pixel - Vector2d(x, y)).norm(), 0, kTolerance);
      }
    }
  }
}

// Enhanced unified model: the point goes to the surface
// alpha sqrt(beta rho^2 + z^2) + (1 - alpha) z = 1 and from there straight
// down to the plane.
TEST(CameraProjection, EUCMMeetsItsDefinition) {
  ExpectProjections({16}, [](const auto& in, const Vector3d& p) -> Vector2d {
    const double alpha = in.extra[0];
    const double beta = in.extra[1];
    const auto level = [&](const Vector3d& q) {
      return alpha *
                 std::sqrt(beta * q.head<2>().squaredNorm() + q.z() * q.z()) +
             (1 - alpha) * q.z();
    };
    const Vector3d on_surface = p / level(p);
    EXPECT_NEAR(level(on_surface), 1, 1e-12);
    return {in.fx * on_surface.x() + in.cx, in.fy * on_surface.y() + in.cy};
  });
}

TEST(CameraProjection, BehindTheCameraNothingProjects) {
  for (const SparseCamera& camera : TestCameras()) {
    const CameraProjector projector(camera);
    const auto behind = projector.ImgFromCam({0, 0, -1});
    const auto nowhere = projector.ImgFromCam({0, 0, 0});
    EXPECT_FALSE(nowhere) << FindCameraModel(camera.model_id)->name;
    // Straight behind an ideal fisheye is its outermost circle.
    EXPECT_FALSE(behind) << FindCameraModel(camera.model_id)->name;
    EXPECT_FALSE(projector.CamFromImg({NAN, 3}));
    EXPECT_FALSE(projector.CamFromImg({INFINITY, 3}));
    EXPECT_FALSE(projector.ImgFromCam({NAN, 0, 1}));
  }
}

// r + k r^3 grows up to r = sqrt(-1 / (3 k)); the pixels farther out have no
// ray, the rays farther out no pixel.
TEST(CameraProjection, EndsWhereTheDistortionFoldsOver) {
  const double k = -0.2;
  const double limit = std::sqrt(-1 / (3 * k));
  const CameraProjector projector(SparseCamera{
      1, camera_model::kSimpleRadial, 640, 480, {500, 320, 240, k}});
  EXPECT_NEAR(projector.Intrinsics().max_radius, limit, 1e-12);
  EXPECT_TRUE(projector.ImgFromCam({limit - 1e-6, 0, 1}));
  EXPECT_FALSE(projector.ImgFromCam({limit + 1e-6, 0, 1}));
  const double farthest = 500 * limit * (1 + k * limit * limit);
  const auto edge = projector.CamFromImg({320 + farthest - 1e-6, 240});
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->x() / edge->z(), limit, 1e-3);
  EXPECT_FALSE(projector.CamFromImg({320 + farthest + 1e-6, 240}));
  // With tangential parts, and close to the edge.
  const CameraProjector skewed(SparseCamera{
      1, camera_model::kOpenCV, 640, 480, {500, 500, 320, 240, k, 0, 1e-3, 0}});
  EXPECT_FALSE(skewed.CamFromImg({320 + farthest + 10, 240}));
  EXPECT_TRUE(skewed.CamFromImg({320 + farthest - 10, 240}));
}

TEST(CameraProjection, GoesOnBeyond90Degrees) {
  const SparseCamera cameras[] = {
      {1, camera_model::kFisheye, 2000, 2000, {300, 310, 1000, 1000}},
      {2,
       camera_model::kOpenCVFisheye,
       2000,
       2000,
       {300, 310, 1000, 1000, 0.01, 0.002, 1e-4, 1e-5}},
      {3, camera_model::kDivision, 2000, 2000, {600, 610, 1000, 1000, -0.9}},
      {4, camera_model::kEUCM, 2000, 2000, {300, 310, 1000, 1000, 0.6, 1.1}},
  };
  for (const SparseCamera& camera : cameras) {
    SCOPED_TRACE(FindCameraModel(camera.model_id)->name);
    const CameraProjector projector(camera);
    for (double degrees = 1; degrees < 110; degrees += 2) {
      const double angle = degrees * pi / 180;
      const Vector3d ray(
          std::sin(angle) * 0.6, std::sin(angle) * -0.8, std::cos(angle));
      const auto pixel = projector.ImgFromCam(ray);
      ASSERT_TRUE(pixel) << degrees;
      const auto back = projector.CamFromImg(*pixel);
      ASSERT_TRUE(back) << degrees;
      ASSERT_NEAR((*back - ray).norm(), 0, 1e-9) << degrees;
    }
  }
}

TEST(CameraProjector, RowsAreWhatSinglePixelsAre) {
  for (const SparseCamera& camera : TestCameras()) {
    SCOPED_TRACE(FindCameraModel(camera.model_id)->name);
    const CameraProjector projector(camera);
    // From far beyond the left edge to far beyond the right one.
    const Vector3d first(-30, 0.2, 1);
    const Vector3d step(0.1, 0, 0);
    constexpr size_t kCount = 600;
    std::vector<float> x(kCount), y(kCount);
    projector.ImgFromCamRow(first, step, kCount, x.data(), y.data());
    for (size_t i = 0; i < kCount; ++i) {
      const auto pixel = projector.ImgFromCam(first + double(i) * step);
      const bool inside = pixel && pixel->cwiseAbs().maxCoeff() < 1e6;
      ASSERT_EQ(x[i], inside ? float(pixel->x()) : CameraProjector::kNoPixel);
      ASSERT_EQ(y[i], inside ? float(pixel->y()) : CameraProjector::kNoPixel);
    }
  }
}

}  // namespace
}  // namespace octacut
