// Which part of a photograph, at which resolution, a reconstruction needs: the
// pinhole camera that a view is undistorted to.
#pragma once

#include <cstddef>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "colmap_io/model/camera_models.h"
#include "core/scene/camera.h"
#include "core/scene/region.h"

namespace octacut {

// Rays are described by their tangents x / z and y / z in the camera's frame.
// Pinhole views end at this tangent (72 degrees off the axis).
inline constexpr double kMaxTangent = 3;

struct Frame {
  Eigen::AlignedBox2d tangents;  // of what the photograph shows
  bool complete = true;          // false: parts lie beyond kMaxTangent
};

// Bounding box of the photograph's frame.
Frame FrameOfCamera(const SparseCamera& camera);

struct WindowOptions {
  // A voxel of the target level gets at least this many pixels of the view
  // along an edge, in all of the region: enough for the octahedron of a voxel
  // to be sampled with no two samples in one pixel.
  double pixels_per_voxel = 1.5;
  // Photographs that would be reduced by less are kept at their own scale.
  double min_reduction = 1.25;
  // Pixels around the region's projection.
  int margin = 4;

  void Check() const;
};

// The window of one view: the projection of the region's box with a margin,
// within the frame, at the resolution that the voxels of `target_level` need
// and never enlarged. Windows of undistorted cameras at full resolution begin
// at whole pixels of the photograph. Empty when the view does not show the
// region.
std::optional<PinholeCamera> PlanWindow(const SparseCamera& camera,
                                        const Frame& frame,
                                        const Rigid3d& cam_from_world,
                                        const Region& region,
                                        int target_level,
                                        const WindowOptions& options);

// Bytes of image and mask of views with these cameras.
size_t SceneBytes(const std::vector<PinholeCamera>& cameras);

}  // namespace octacut
