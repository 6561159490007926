#include "core/raycast/depth_normals.h"

#include <cmath>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <optional>

#include "core/base/parallel_pixels.h"
#include "core/mesh/triangle_normal.h"

namespace octacut {
namespace {

constexpr int kLeastPoints = 6;
// A surface at some 70 degrees falls off by three pixels' sizes a pixel.
constexpr double kSteepest = 3;

DepthAndNormals Empty(int width, int height) {
  return {cv::Mat::zeros(height, width, CV_32FC1),
          cv::Mat::zeros(height, width, CV_32FC3)};
}

cv::Vec3f FacingCamera(const Eigen::Vector3d& normal,
                       const Eigen::Vector3d& ray) {
  const Eigen::Vector3d n =
      normal.dot(ray) > 0 ? Eigen::Vector3d(-normal) : normal;
  return {float(n.x()), float(n.y()), float(n.z())};
}

std::optional<Eigen::Vector3d> PlaneNormal(const cv::Mat& depth,
                                           const PinholeCamera& camera,
                                           int x,
                                           int y,
                                           int radius) {
  const double middle = depth.at<float>(y, x);
  const double limit = kSteepest * (radius + 1) * middle / camera.fx;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  const Eigen::Vector3d origin = middle * camera.Unproject({x + 0.5, y + 0.5});
  int count = 0;
  for (int v = std::max(0, y - radius);
       v <= std::min(depth.rows - 1, y + radius);
       ++v) {
    for (int u = std::max(0, x - radius);
         u <= std::min(depth.cols - 1, x + radius);
         ++u) {
      const double z = depth.at<float>(v, u);
      if (z > 0 && std::abs(z - middle) <= limit) {
        const Eigen::Vector3d point =
            z * camera.Unproject({u + 0.5, v + 0.5}) - origin;
        sum += point;
        products += point * point.transpose();
        ++count;
      }
    }
  }
  if (count < kLeastPoints) {
    return std::nullopt;
  }
  const Eigen::Vector3d mean = sum / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      products / count - mean * mean.transpose());
  // Points on a line have no plane.
  if (!(solver.eigenvalues()[1] > 1e-6 * solver.eigenvalues()[2])) {
    return std::nullopt;
  }
  return solver.eigenvectors().col(0);
}

}  // namespace

DepthAndNormals RenderDepthAndNormals(const IndexedMesh& mesh,
                                      const RayScene& rays,
                                      const PinholeCamera& camera,
                                      const Rigid3d& cam_from_world,
                                      const Context& context) {
  DepthAndNormals result = Empty(camera.width, camera.height);
  const Rigid3d world_from_cam = cam_from_world.Inverse();
  ParallelPixels(context, camera.width, camera.height, [&](int x, int y) {
    const Eigen::Vector3d ray = camera.Unproject({x + 0.5, y + 0.5});
    const auto hit = rays.FirstHit(world_from_cam.translation,
                                   world_from_cam.rotation * ray);
    if (!hit) {
      return;
    }
    const Eigen::Vector3d normal =
        AreaNormal(mesh, mesh.triangles[hit->triangle]).stableNormalized();
    result.depth.at<float>(y, x) = float(hit->distance);
    result.normals.at<cv::Vec3f>(y, x) =
        FacingCamera(cam_from_world.rotation * normal, ray);
  });
  return result;
}

DepthAndNormals FitNormals(const cv::Mat& depth,
                           const PinholeCamera& camera,
                           int radius,
                           const Context& context) {
  DepthAndNormals result = Empty(depth.cols, depth.rows);
  ParallelPixels(context, depth.cols, depth.rows, [&](int x, int y) {
    if (!(depth.at<float>(y, x) > 0)) {
      return;
    }
    if (const auto normal = PlaneNormal(depth, camera, x, y, radius)) {
      result.depth.at<float>(y, x) = depth.at<float>(y, x);
      result.normals.at<cv::Vec3f>(y, x) =
          FacingCamera(*normal, camera.Unproject({x + 0.5, y + 0.5}));
    }
  });
  return result;
}

}  // namespace octacut
