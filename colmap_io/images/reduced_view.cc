#include "colmap_io/images/reduced_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "colmap_io/images/view_window.h"
#include "colmap_io/model/camera_projector.h"

namespace octacut {
namespace {

// Distance in pixels of the places where a lens is evaluated when values are
// carried back; between them its distortion is as good as linear.
constexpr int kLensStep = 8;

// Where `reduced` shows what the photograph has at a pixel; not numbers where
// the lens gives it no ray.
cv::Vec2f PlaceInReduced(const CameraProjector& projector,
                         const Eigen::Vector2d& pixel,
                         const PinholeCamera& reduced) {
  const auto ray = projector.CamFromImg(pixel);
  if (!ray || !(ray->z() > 0)) {
    return cv::Vec2f::all(std::numeric_limits<float>::quiet_NaN());
  }
  const Eigen::Vector2d place = reduced.Project(*ray);
  return {float(place.x() - 0.5), float(place.y() - 0.5)};
}

}  // namespace

PinholeCamera ReducedCamera(const SparseCamera& camera, int longest_side) {
  const CameraIntrinsics intrinsics = CameraProjector(camera).Intrinsics();
  const Eigen::AlignedBox2d tangents = FrameOfCamera(camera).tangents;
  const double width = tangents.sizes().x() * intrinsics.fx;
  const double height = tangents.sizes().y() * intrinsics.fy;
  const double factor = std::min(1.0, longest_side / std::max(width, height));
  PinholeCamera reduced;
  reduced.width = std::max(1, int(std::lround(width * factor)));
  reduced.height = std::max(1, int(std::lround(height * factor)));
  reduced.fx = reduced.width / tangents.sizes().x();
  reduced.fy = reduced.height / tangents.sizes().y();
  reduced.cx = -tangents.min().x() * reduced.fx;
  reduced.cy = -tangents.min().y() * reduced.fy;
  return reduced;
}

cv::Mat ReduceView(const cv::Mat& photograph,
                   const SparseCamera& camera,
                   const PinholeCamera& target) {
  const CameraProjector projector(camera);
  const double reduction = std::max(1.0, projector.Intrinsics().fx / target.fx);
  const cv::Size size(
      std::max(1, int(std::lround(photograph.cols / reduction))),
      std::max(1, int(std::lround(photograph.rows / reduction))));
  cv::Mat small;
  cv::resize(photograph, small, size, 0, 0, cv::INTER_AREA);
  const float scale_x = float(size.width) / float(photograph.cols);
  const float scale_y = float(size.height) / float(photograph.rows);
  cv::Mat x(target.height, target.width, CV_32F);
  cv::Mat y(target.height, target.width, CV_32F);
  for (int row = 0; row < target.height; ++row) {
    projector.ImgFromCamRow(target.Unproject({0.5, row + 0.5}),
                            {1 / target.fx, 0, 0},
                            size_t(target.width),
                            x.ptr<float>(row),
                            y.ptr<float>(row));
  }
  x = x * scale_x - 0.5;
  y = y * scale_y - 0.5;
  cv::Mat result;
  cv::remap(small, result, x, y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return result;
}

cv::Mat CarryBack(const cv::Mat& values,
                  const PinholeCamera& reduced,
                  const SparseCamera& camera) {
  const CameraProjector projector(camera);
  const int columns = int(camera.width);
  const int rows = int(camera.height);
  // One place more than fits, so that the last pixels lie between two places.
  cv::Mat coarse(rows / kLensStep + 2, columns / kLensStep + 2, CV_32FC2);
  for (int j = 0; j < coarse.rows; ++j) {
    for (int i = 0; i < coarse.cols; ++i) {
      coarse.at<cv::Vec2f>(j, i) =
          PlaceInReduced(projector,
                         {std::min(i * kLensStep, columns) + 0.5,
                          std::min(j * kLensStep, rows) + 0.5},
                         reduced);
    }
  }
  cv::Mat map(rows, columns, CV_32FC2);
  cv::Mat has_no_ray = cv::Mat::zeros(rows, columns, CV_8U);
  for (int y = 0; y < rows; ++y) {
    const int j = y / kLensStep;
    const float b = float(y % kLensStep) /
                    float(std::min((j + 1) * kLensStep, rows) - j * kLensStep);
    for (int x = 0; x < columns; ++x) {
      const int i = x / kLensStep;
      const float a =
          float(x % kLensStep) /
          float(std::min((i + 1) * kLensStep, columns) - i * kLensStep);
      const cv::Vec2f above = coarse.at<cv::Vec2f>(j, i) * (1 - a) +
                              coarse.at<cv::Vec2f>(j, i + 1) * a;
      const cv::Vec2f below = coarse.at<cv::Vec2f>(j + 1, i) * (1 - a) +
                              coarse.at<cv::Vec2f>(j + 1, i + 1) * a;
      cv::Vec2f place = above * (1 - b) + below * b;
      if (std::isnan(place[0])) {  // the lens ends here
        place = PlaceInReduced(projector, {x + 0.5, y + 0.5}, reduced);
        if (std::isnan(place[0])) {
          has_no_ray.at<uint8_t>(y, x) = 255;
          place = {};
        }
      }
      map.at<cv::Vec2f>(y, x) = place;
    }
  }
  cv::Mat result;
  cv::remap(
      values, result, map, cv::Mat(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  result.setTo(0, has_no_ray);
  return result;
}

}  // namespace octacut
