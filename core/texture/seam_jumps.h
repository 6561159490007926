// Jumps of colour across the borders of charts.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <vector>

#include "core/mesh/indexed_mesh.h"
#include "core/texture/atlas_layout.h"
#include "core/texture/photographs.h"
#include "core/texture/textured_mesh.h"

namespace octacut {

struct SeamJumps {
  size_t num_points = 0;
  // Means over the borders between textured charts, grey levels (0 to 255, the
  // mean of the channels).
  double before = 0;  // of the photographs as they are
  double after = 0;   // of the finished texture
};

// Points along the borders between charts of different photographs.
class SeamPoints {
 public:
  SeamPoints(const IndexedMesh& mesh,
             const std::vector<std::array<uint32_t, 3>>& neighbors,
             const AtlasLayout& layout);

  // Takes the colours of one of the photographs.
  void Sample(uint32_t view, const PhotographPose& pose, const cv::Mat& image);
  SeamJumps Measure(const TexturedMesh& textured) const;

 private:
  struct Side {
    uint32_t face;
    uint32_t view;
    Eigen::Vector3f weights;  // of the corners
    Eigen::Vector3f raw = Eigen::Vector3f::Zero();
  };
  struct Point {
    Eigen::Vector3d position;
    std::array<Side, 2> sides;
  };
  std::vector<Point> points_;
};

}  // namespace octacut
