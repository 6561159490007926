// Photographs of printed markers that lie on the plane z = 0.
#pragma once

#include <array>
#include <Eigen/Dense>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/scene/camera.h"

namespace octacut {

struct PrintedMarker {
  int id = 0;
  Eigen::Vector2d corner;  // the marker's first one, on the plane
  double side = 1;

  // In the order in which they are detected: the picture's y points down, the
  // plane's up.
  std::array<Eigen::Vector3d, 4> Corners() const {
    return {Eigen::Vector3d(corner.x(), corner.y(), 0),
            Eigen::Vector3d(corner.x() + side, corner.y(), 0),
            Eigen::Vector3d(corner.x() + side, corner.y() - side, 0),
            Eigen::Vector3d(corner.x(), corner.y() - side, 0)};
  }
};

// Looks from `center` at the origin, with +z of the world up in the image.
inline Rigid3d LookAtOrigin(const Eigen::Vector3d& center) {
  const Eigen::Vector3d forward = -center.normalized();
  const Eigen::Vector3d right =
      forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Rigid3d cam_from_world;
  cam_from_world.rotation.row(0) = right;
  cam_from_world.rotation.row(1) = forward.cross(right);
  cam_from_world.rotation.row(2) = forward;
  cam_from_world.translation = -(cam_from_world.rotation * center);
  return cam_from_world;
}

// Grey, of markers of OpenCV's 4x4_50 on white paper.
inline cv::Mat RenderMarkers(const std::vector<PrintedMarker>& markers,
                             const PinholeCamera& camera,
                             const Rigid3d& cam_from_world) {
  constexpr int kFiner = 4;    // antialiasing
  constexpr int kCells = 240;  // pixels of a marker's picture
  cv::Mat fine(
      camera.height * kFiner, camera.width * kFiner, CV_8UC1, cv::Scalar(220));
  const auto dictionary =
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50);
  for (const PrintedMarker& marker : markers) {
    cv::Mat picture;
    cv::aruco::drawMarker(dictionary, marker.id, kCells, picture, 1);
    std::vector<cv::Point2f> from = {{-0.5f, -0.5f},
                                     {kCells - 0.5f, -0.5f},
                                     {kCells - 0.5f, kCells - 0.5f},
                                     {-0.5f, kCells - 0.5f}};
    std::vector<cv::Point2f> to;
    for (const Eigen::Vector3d& corner : marker.Corners()) {
      const Eigen::Vector2d pixel =
          kFiner * camera.Project(cam_from_world * corner);
      to.emplace_back(float(pixel.x() - 0.5), float(pixel.y() - 0.5));
    }
    cv::warpPerspective(picture,
                        fine,
                        cv::getPerspectiveTransform(from, to),
                        fine.size(),
                        cv::INTER_NEAREST,
                        cv::BORDER_TRANSPARENT);
  }
  cv::Mat image;
  cv::resize(fine, image, {camera.width, camera.height}, 0, 0, cv::INTER_AREA);
  return image;
}

}  // namespace octacut
