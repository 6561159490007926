// The photographs that a mesh is textured from, read when they are needed.
#pragma once

#include <cstddef>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/scene/camera.h"

namespace octacut {

// What is known of a photograph before it is read.
struct PhotographPose {
  std::string name;  // as the sparse model has it
  PinholeCamera camera;
  Rigid3d cam_from_world;

  Eigen::Vector3d Center() const {
    return cam_from_world.Inverse().translation;
  }
};

// Undistorted, of the size of its camera.
struct Photograph {
  cv::Mat image;  // CV_8UC3, BGR
  // CV_8UC1: 255 where the pixel shows the object, or where no mask says that
  // it does not; 0 for background and where the photograph does not reach.
  cv::Mat mask;
};

struct Photographs {
  std::vector<PhotographPose> poses;
  // Reads photograph `i`; may be called from any thread. Throws InputError.
  std::function<Photograph(size_t i)> load;
  // How many may be held at a time, so that memory stays bounded.
  size_t max_held = 1;
};

}  // namespace octacut
