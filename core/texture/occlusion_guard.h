// Where a photograph's pixels mix the surface with what is before, beside or
// behind it.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/scene/camera.h"
#include "core/texture/face_neighbors.h"

namespace octacut {

class OcclusionGuard {
 public:
  // `tolerance` is a length below which depths count as the same.
  OcclusionGuard(const PinholeCamera& camera,
                 const cv::Mat& mask,
                 double tolerance);

  // Contours are the edges between triangles that face the camera (`is_front`,
  // for each) and others, and borders of the mesh. `in_camera`: its vertices.
  void AddContours(const std::vector<std::array<uint32_t, 3>>& triangles,
                   const std::vector<std::array<uint32_t, 3>>& neighbors,
                   const std::vector<uint8_t>& is_front,
                   const std::vector<Eigen::Vector3f>& in_camera);

  // Whether the mask shows the object at a pixel.
  bool IsObject(double u, double v) const { return Distance(u, v) > 0; }
  // Whether a point at that depth is kGuardPixels away from background, and
  // from every contour that is not behind it.
  bool IsSure(double u, double v, double depth) const;

 private:
  void DrawEdge(const Eigen::Vector3f& a, const Eigen::Vector3f& b);
  void DrawDisc(double u, double v, float depth);
  float Distance(double u, double v) const;

  PinholeCamera camera_;
  cv::Mat distance_;  // CV_32F: pixels to the background; of the mask
  cv::Mat contours_;  // CV_32F: depth of the nearest contour around
  double tolerance_;
};

}  // namespace octacut
