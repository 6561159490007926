// What a reconstruction is made from: undistorted views of one object with
// silhouettes, and what structure from motion knows of its surface.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "core/scene/camera.h"

namespace octacut {

// Value of a mask from which on a pixel counts as object.
inline constexpr int kObjectThreshold = 128;

// One view, cropped to the object and held at the resolution that the target
// level needs. `image` and `mask` have the size of `camera`.
//
// A view says nothing about what projects outside its frame, nor about pixels
// of the frame that the photograph does not cover (borders left by
// undistortion): `unknown` is 255 there, and so is `mask`.
struct View {
  std::string name;  // of the photograph, as the sparse model has it
  PinholeCamera camera;
  Rigid3d cam_from_world;
  cv::Mat image;    // CV_8UC3, BGR (OpenCV's order); empty where not needed
  cv::Mat mask;     // CV_8UC1, 255 = object, 0 = background; values between are
                    // coverage by the object
  cv::Mat unknown;  // CV_8UC1, 255 or 0; empty where the photograph covers all
  double scale = 1;  // pixels of this view per pixel of the photograph

  Eigen::Vector3d Center() const {
    return cam_from_world.Inverse().translation;
  }
};

// A cube in world coordinates: the root voxel V^0. In unit coordinates it is
// [0, 1]^3.
struct BoundingCube {
  Eigen::Vector3d min_corner = Eigen::Vector3d::Zero();
  double edge = 0;

  Eigen::Vector3d Center() const {
    return min_corner + Eigen::Vector3d::Constant(edge / 2);
  }
  double VoxelSize(int level) const { return edge / double(1u << level); }

  Eigen::Vector3d ToUnit(const Eigen::Vector3d& world) const {
    return (world - min_corner) / edge;
  }
  Eigen::AlignedBox3f ToUnit(const Eigen::AlignedBox3d& world) const {
    return {ToUnit(world.min()).cast<float>(),
            ToUnit(world.max()).cast<float>()};
  }
};

// Pixels of the photographs by which masks may be said to be wrong, at most.
inline constexpr double kMaxMaskTolerance = 64;

struct Scene {
  std::vector<View> views;
  // Sparse points of the object with small reprojection error, in world
  // coordinates: those that lie in four in five of the masks. May be empty.
  std::vector<Eigen::Vector3d> points;
};

}  // namespace octacut
