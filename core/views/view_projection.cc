#include "core/views/view_projection.h"

namespace octacut {

ViewProjection MakeViewProjection(const View& view, const BoundingCube& cube) {
  const PinholeCamera& camera = view.camera;
  Eigen::Matrix3d calibration = Eigen::Matrix3d::Identity();
  calibration(0, 0) = camera.fx;
  calibration(1, 1) = camera.fy;
  calibration(0, 2) = camera.cx;
  calibration(1, 2) = camera.cy;
  const Rigid3d& pose = view.cam_from_world;
  ViewProjection projection;
  projection.linear = (calibration * pose.rotation).cast<float>();
  // In units of the cube's edge, the camera's translation seen from the
  // cube's corner: subtracted in double so that a far origin costs no digits.
  projection.offset =
      (calibration * ((pose * cube.min_corner) / cube.edge)).cast<float>();
  projection.center = cube.ToUnit(view.Center()).cast<float>();
  projection.focal_length = float((camera.fx + camera.fy) / 2);
  projection.width = camera.width;
  projection.height = camera.height;
  return projection;
}

}  // namespace octacut
