// Projection with one of COLMAP's cameras, prepared once for many rays: what
// undistortion maps are made with.
//
// Frames and units as COLMAP has them: camera frame x right, y down, z
// forward; pixel coordinates with the image's top-left corner at (0, 0) and
// the centre of the first pixel at (0.5, 0.5). The formulas are those of
// COLMAP 4.1 (sensor/models.h), which older versions share for the models
// they know.
//
// Two things differ from COLMAP on purpose, both outside of what it can
// invert itself:
// - A ray beyond the radius where the radial distortion stops growing does
//   not project, instead of being folded back into the image.
// - Fisheye, division and EUCM models go on beyond 90 degrees off the axis as
//   far as their formula is invertible.
#pragma once

#include <array>
#include <cstddef>
#include <Eigen/Core>
#include <limits>
#include <optional>

#include "colmap_io/model/camera_models.h"

namespace octacut {

// Parameters in the one form that all models share.
struct CameraIntrinsics {
  double fx = 1;  // pixels; equal to fy for models with a single f
  double fy = 1;
  double cx = 0;
  double cy = 0;
  // Distortion in COLMAP's order; behind it what a model prepares.
  std::array<double, 12> extra{};

  // Radius up to which the radial distortion grows, so that it can be
  // inverted: of normalized coordinates (perspective models, may be infinite)
  // or in radians off the axis (fisheye models, at most pi).
  double max_radius = std::numeric_limits<double>::infinity();
};

// Thread safe: const members may be called from any thread.
class CameraProjector {
 public:
  // Stands for a pixel in ImgFromCamRow where the ray does not project; far
  // outside of any image and safe to hand to cv::remap.
  static constexpr float kNoPixel = -1e6f;

  // Checks the camera as CheckCamera does.
  explicit CameraProjector(const SparseCamera& camera);

  // Pixel of a ray (a point in the camera's frame, any length); none where it
  // does not project.
  std::optional<Eigen::Vector2d> ImgFromCam(const Eigen::Vector3d& ray) const;
  // Unit ray in the camera's frame of a pixel, the inverse of ImgFromCam; its z
  // may be <= 0 for wide fisheyes. None where no ray projects there.
  std::optional<Eigen::Vector3d> CamFromImg(const Eigen::Vector2d& pixel) const;

  // Pixels of the rays first + i * step, i = 0 .. count - 1, to x[i] and
  // y[i]; both kNoPixel where the ray does not project. One dispatch a call,
  // no allocation. Subtract 0.5 from each coordinate for OpenCV's convention.
  void ImgFromCamRow(const Eigen::Vector3d& first,
                     const Eigen::Vector3d& step,
                     size_t count,
                     float* x,
                     float* y) const;

  const CameraIntrinsics& Intrinsics() const { return intrinsics_; }

 private:
  int model_id_;
  CameraIntrinsics intrinsics_;
};

}  // namespace octacut
